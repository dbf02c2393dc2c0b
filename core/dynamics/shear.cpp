// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/shear.h"

#include "core/foam/lattice.h"

namespace foam {

void shear(Foam& foam, double strain) {
    foam.domain.shear += strain * foam.domain.height;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 at = foam.positions[junction];
        place_junction(foam, junction, {at.x() + strain * at.y(), at.y()});
    }
    reduce_lattice(foam);
}

}  // namespace foam
