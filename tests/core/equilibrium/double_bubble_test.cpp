#include "core/equilibrium/double_bubble.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

FilmId inner_film(const Foam& foam) {
    return film_of(test::side_between(foam.network, BubbleId{0}, BubbleId{1}));
}

TEST(DoubleBubble, IsARaftOfTwo) {
    const Foam two = test::double_bubble(1.0, 1.0);
    for (const FilmId film : two.network.films()) {
        EXPECT_EQ(is_inside_double_bubble(two.network, film), film == inner_film(two));
    }
    const Foam four = test::chain();
    for (const FilmId film : four.network.films()) {
        EXPECT_FALSE(is_inside_double_bubble(four.network, film));
    }
}

// All errors of an equilibrium are rounding, whichever of the two is the larger one. Where the
// outer film is nearly a full circle, its area amplifies the rounding of its half angle.
TEST(DoubleBubble, SettlesToEquilibriumInClosedForm) {
    for (const double ratio : {1.0, 0.5, 3.0, 100.0, 0.001}) {
        Foam foam = test::double_bubble(0.7, 0.7 * ratio);
        foam.film_tension = 1.3;
        settle_double_bubble(foam, inner_film(foam));
        const EquilibriumErrors errors = equilibrium_errors(foam);
        EXPECT_LT(errors.area, 1e-12) << ratio;
        EXPECT_LT(errors.angle, 1e-13) << ratio;
        EXPECT_LT(errors.arc, 1e-13) << ratio;
    }
}

TEST(DoubleBubble, IsWhatTheSolverFinds) {
    for (const double ratio : {1.0, 0.3, 30.0}) {
        Foam closed = test::double_bubble(1.0, ratio);
        settle_double_bubble(closed, inner_film(closed));
        Foam solved = closed;
        for (Vec2& position : solved.positions) {
            position *= 1.02;
        }
        for (double& angle : solved.half_angles) {
            angle *= 0.98;
        }
        EquilibriumOptions options;
        options.relaxes_first = false;
        const EquilibriumSummary summary = equilibrate(solved, options);
        EXPECT_TRUE(summary.converged());
        EXPECT_EQ(summary.sweeps, 0);
        EXPECT_NEAR(summary.energy, energy(closed), 1e-10);
        EXPECT_NEAR(solved.pressures[BubbleId{1}], closed.pressures[BubbleId{1}], 1e-9);
    }
}

}  // namespace
}  // namespace foam
