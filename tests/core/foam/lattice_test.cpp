// SPDX-License-Identifier: Apache-2.0

#include "core/foam/lattice.h"

#include "core/dynamics/shear.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

using test::equilibrated_foam;

// The lattice with the periods (w, 0) and (s, h) also has the periods (w, 0) and (s + w, h).
TEST(Lattice, TheReducedLatticeIsTheSame) {
    Foam foam = equilibrated_foam(40, 1);
    const double width = foam.domain.width;
    shear(foam, 0.45);
    const Foam before = foam;
    foam.domain.shear += width;  // other periods of the same lattice
    for (const FilmId film : foam.network.films()) {
        const LatticeOffset offset = foam.network.offset(forward_side(film));
        foam.network.set_offset(forward_side(film), {offset.i - offset.j, offset.j});
    }
    EXPECT_EQ(reduced_lattice(foam.domain).widths, 1);
    reduce_lattice(foam);
    EXPECT_NEAR(foam.domain.shear, before.domain.shear, 1e-15 * width);
    for (const FilmId film : foam.network.films()) {
        EXPECT_TRUE(foam.network.offset(forward_side(film)) ==
                    before.network.offset(forward_side(film)));
    }
}

}  // namespace
}  // namespace foam
