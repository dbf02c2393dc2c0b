// SPDX-License-Identifier: Apache-2.0

#include "core/foam/lattice.h"

#include <cmath>

namespace foam {

ReducedLattice reduced_lattice(const Domain& domain) {
    ReducedLattice result{domain};
    if (std::abs(domain.shear) > 0.5 * domain.width) {
        result.widths = static_cast<std::int32_t>(std::lround(domain.shear / domain.width));
        result.domain.shear -= result.widths * domain.width;
    }
    return result;
}

void reduce_lattice(Foam& foam) {
    const ReducedLattice lattice = reduced_lattice(foam.domain);
    foam.domain = lattice.domain;
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        foam.network.set_offset(h, lattice.reduced(foam.network.offset(h)));
    }
}

}  // namespace foam
