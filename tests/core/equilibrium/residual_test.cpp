// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/residual.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/geometry/bulge_energy.h"
#include "core/geometry/film_energy.h"
#include "tests/core/equilibrium/derivative_foams.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace foam {
namespace {

using test::derivative_foams;
using test::shifted;

double largest(const Eigen::VectorXd& v) {
    return v.cwiseAbs().maxCoeff();
}

std::vector<Foam> all_derivative_foams() {
    std::vector<Foam> foams = derivative_foams();
    const std::vector<Foam> patches = test::derivative_patches();
    foams.insert(foams.end(), patches.begin(), patches.end());
    return foams;
}

// Returns the value of the function L of E3 for the whole foam.
double lagrangian(const Foam& foam) {
    double sum = 0.0;
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        const double delta = pressure_difference(foam, h);
        sum += foam.network.is_outer(film)
                   ? bulge_energy(film_arc(foam, h), delta, foam.film_tension).value
                   : film_energy(chord(foam, h), delta, foam.film_tension).value;
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        sum -= foam.pressures[bubble] * (polygon_area(foam, bubble) - foam.target_areas[bubble]);
    }
    return sum;
}

// Energies are up to 100 and the step is 1e-5: rounding errors are 100 * 1e-16 / 1e-5 = 1e-9. The
// cubic term is h²/6 times third derivatives, which are of the order of T / c² and reach 1e3 for
// the shortest films.
TEST(Residual, IsTheCentralDifferenceOfTheLagrangianByEachUnknown) {
    constexpr double kStep = 1e-5;
    for (const Foam& foam : all_derivative_foams()) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::VectorXd r = residual(foam, unknowns);
        ASSERT_EQ(r.size(), unknowns.size());
        for (int row = 0; row < unknowns.size(); ++row) {
            const double difference = (lagrangian(shifted(foam, unknowns, row, kStep)) -
                                       lagrangian(shifted(foam, unknowns, row, -kStep))) /
                                      (2.0 * kStep);
            EXPECT_NEAR(r[row], difference, 1e-6) << "row " << row;
        }
    }
}

TEST(Residual, OfAPressureIsTheMissingArea) {
    for (const Foam& foam : all_derivative_foams()) {
        const Unknowns unknowns = all_unknowns(foam.network);
        const Eigen::VectorXd r = residual(foam, unknowns);
        for (const BubbleId bubble : unknowns.bubbles) {
            EXPECT_NEAR(r[unknowns.pressure_row(bubble)],
                        foam.target_areas[bubble] - bubble_area(foam, bubble),
                        1e-13);
        }
    }
}

// At a junction the gradient is minus the tension times the sum of the arcs' unit tangents (E3).
// The force of the pressures on the chords is included, because it is the difference between the
// tangents and the directions of the chords.
TEST(Residual, OfAPositionIsMinusThePullOfTheArcs) {
    const Foam foam = test::bent_foam(40, 0.5, 3);
    ASSERT_EQ(equilibrium_errors(foam).films_at_limit, 0);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::VectorXd r = residual(foam, unknowns);
    for (const JunctionId junction : unknowns.junctions) {
        Vec2 pull = Vec2::Zero();
        for (const HalfEdgeId h : foam.network.leaving(junction)) {
            pull += foam.film_tension * tangent_at_tail(film_arc(foam, h));
        }
        EXPECT_LT((r.segment<2>(unknowns.position_row(junction)) + pull).norm(), 1e-13);
    }
}

TEST(Residual, VanishesInTheHoneycomb) {
    for (int columns = 1; columns <= 3; ++columns) {
        const Foam foam = honeycomb(columns, 4);
        EXPECT_LT(largest(residual(foam, all_unknowns(foam.network))), 1e-14);
        EXPECT_NEAR(lagrangian(foam), energy(foam), 1e-13);
    }
}

// A common change of all pressures exerts no force.
TEST(Residual, DoesNotDependOnTheMeanPressure) {
    const Foam foam = test::bent_foam(30, 1.0, 8);
    Foam raised = foam;
    for (double& pressure : raised.pressures) {
        pressure += 10.0;
    }
    const Unknowns unknowns = all_unknowns(foam.network);
    EXPECT_LT(largest(residual(foam, unknowns) - residual(raised, unknowns)), 1e-13);
}

TEST(Residual, ForcesAddUpToZeroAndAreasToTheTorus) {
    const Foam foam = test::bent_foam(30, 1.0, 8);
    const Unknowns unknowns = all_unknowns(foam.network);
    const Eigen::VectorXd r = residual(foam, unknowns);
    Vec2 force = Vec2::Zero();
    for (const JunctionId junction : unknowns.junctions) {
        force += r.segment<2>(unknowns.position_row(junction));
    }
    EXPECT_LT(force.norm(), 1e-13);
    EXPECT_NEAR(r.tail(30).sum(), 0.0, 1e-13);
}

// The foam has two bubbles of target areas 1 and 4, four junctions, and T = 2. Forces of 5 (3-4-5)
// and 0.6 are 2.5 and 0.3 film tensions. Area errors of 0.5 and 1 are a half and a quarter of the
// target areas.
TEST(ResidualNorms, AreInTensionsAndTargetAreas) {
    Foam foam = honeycomb(1, 2);
    foam.film_tension = 2.0;
    foam.target_areas[BubbleId{1}] = 4.0;
    foam.target_areas[BubbleId{0}] = 1.0;
    Eigen::VectorXd r = Eigen::VectorXd::Zero(10);
    r[2] = 3.0;
    r[3] = -4.0;
    r[7] = 0.6;
    r[8] = -0.5;
    r[9] = 1.0;
    const ResidualNorms n = norms(foam, all_unknowns(foam.network), r);
    EXPECT_DOUBLE_EQ(n.force, 2.5);
    EXPECT_DOUBLE_EQ(n.area, 0.5);
    EXPECT_DOUBLE_EQ(n.squares, 6.25 + 0.09 + 0.25 + 0.0625);
}

// Rows 0 to 7 are those of four junctions, rows 8 and 9 those of two bubbles.
TEST(ResidualNorms, AreNanWhereTheResidualIs) {
    const Foam foam = honeycomb(1, 2);
    const Unknowns unknowns = all_unknowns(foam.network);
    for (const int row : {0, 4, 7}) {
        Eigen::VectorXd r = Eigen::VectorXd::Constant(10, 0.5);
        r[row] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_TRUE(std::isnan(norms(foam, unknowns, r).force)) << row;
        EXPECT_EQ(norms(foam, unknowns, r).area, 0.5) << row;
    }
    for (const int row : {8, 9}) {
        Eigen::VectorXd r = Eigen::VectorXd::Constant(10, 0.5);
        r[row] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_TRUE(std::isnan(norms(foam, unknowns, r).area)) << row;
    }
}

}  // namespace
}  // namespace foam
