// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/reopen_collapsed_bubbles.h"

#include "core/equilibrium/equilibrate.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace foam {
namespace {

constexpr FilmId kFilm{7};

// A lens in the middle of a film of the honeycomb, of length sqrt(2 / sqrt(27)), covers a
// thousandth of it. Each end moves by a third of the length of the film on its side, so that the
// lens then covers a third of the original film.
TEST(ReopenCollapsedBubbles, MovesTheEndsApartAlongTheirThirdFilms) {
    Foam foam = honeycomb(4, 4);
    const double film = chord(foam, forward_side(kFilm)).norm();
    const BubbleId lens = test::insert_lens(foam, kFilm, 1e-3);
    foam.target_areas[lens] = 1.0;
    EXPECT_EQ(reopen_collapsed_bubbles(foam), 1);
    const double length = chord(foam, foam.network.first(lens)).norm();
    EXPECT_NEAR(length, film * (1e-3 + 2.0 / 3.0 * 0.4995), 1e-12);
    EXPECT_NEAR(foam.pressures[lens], std::numbers::sqrt3 * foam.film_tension / length, 1e-9);
    EXPECT_EQ(untangle(foam), 0);
}

// The ends move apart by at most the chord c of the lens in equilibrium. A lens whose films meet at
// 120 degrees has the area c²/2 (pi/3 - sqrt(3)/4) / (3/4).
TEST(ReopenCollapsedBubbles, ReopensNoFurtherThanToEquilibrium) {
    Foam foam = honeycomb(4, 4);
    const BubbleId lens = test::insert_lens(foam, kFilm, 1e-3);
    constexpr double kChord = 0.1;
    foam.target_areas[lens] =
        kChord * kChord / 1.5 * (std::numbers::pi / 3.0 - std::numbers::sqrt3 / 4.0);
    EXPECT_EQ(reopen_collapsed_bubbles(foam), 1);
    const double before = 1e-3 * chord(honeycomb(4, 4), forward_side(kFilm)).norm();
    EXPECT_NEAR(chord(foam, foam.network.first(lens)).norm(), before + kChord, 1e-12);
}

TEST(ReopenCollapsedBubbles, KeepsOpenBubbles) {
    Foam foam = honeycomb(4, 4);
    const BubbleId lens = test::insert_lens(foam, kFilm, 0.5);
    foam.target_areas[lens] = bubble_area(foam, lens);
    const Foam before = foam;
    EXPECT_EQ(reopen_collapsed_bubbles(foam), 0);
    EXPECT_TRUE(test::are_same(foam, before));
}

// If such a bubble were not reopened, its pressure would grow from relaxation to relaxation until
// it tore the foam apart.
TEST(ReopenCollapsedBubbles, EquilibratesAFoamWithACollapsedBubble) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam foam = test::equilibrated_foam(30, seed);
        const BubbleId lens = test::insert_lens(foam, kFilm, 1e-6);
        foam.target_areas[lens] = 0.8;
        const double scale = foam.domain.area() / test::total_target(foam);
        for (double& area : foam.target_areas) {
            area *= scale;
        }
        EXPECT_TRUE(equilibrate(foam, {.relaxes_first = false}).converged()) << "seed " << seed;
        EXPECT_NEAR(bubble_area(foam, lens), foam.target_areas[lens], 1e-9);
    }
}

}  // namespace
}  // namespace foam
