// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/shear.h"

#include "core/foam/lattice.h"

namespace foam {

void shear(Foam& foam, double strain) {
    foam.domain.shear += strain * foam.domain.height;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 position = foam.positions[junction];
        place_junction(foam, junction, {position.x() + strain * position.y(), position.y()});
    }
    reduce_lattice(foam);
}

}  // namespace foam
