// SPDX-License-Identifier: Apache-2.0

#include "core/foam/lattice.h"

#include <cmath>
#include <cstdint>

namespace foam {

void reduce_lattice(Foam& foam) {
    Domain& domain = foam.domain;
    if (std::abs(domain.shear) <= 0.5 * domain.width) {
        return;
    }
    // The old period (shear, height) equals the new one plus this many periods (width, 0).
    const auto widths = static_cast<std::int32_t>(std::lround(domain.shear / domain.width));
    domain.shear -= widths * domain.width;
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const LatticeOffset offset = foam.network.offset(h);
        foam.network.set_offset(h, {offset.i + widths * offset.j, offset.j});
    }
}

}  // namespace foam
