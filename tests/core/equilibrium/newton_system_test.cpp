// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/newton_system.h"

#include "core/equilibrium/residual.h"
#include "core/foam/honeycomb.h"
#include "core/foam/random.h"
#include "core/network/t1.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

// Returns a honeycomb whose junctions are moved by up to 0.05 in x and y.
Foam perturbed_honeycomb(int side) {
    Foam foam = honeycomb(side, side);
    Random random(3);
    for (Vec2& position : foam.positions) {
        const double x = 0.05 * (2.0 * random.uniform() - 1.0);
        const double y = 0.05 * (2.0 * random.uniform() - 1.0);
        position += Vec2(x, y);
    }
    return foam;
}

struct Case {
    explicit Case(int side)
        : foam(perturbed_honeycomb(side)),
          unknowns(all_unknowns(foam.network)),
          r(residual(foam, unknowns)) {}

    Foam foam;
    Unknowns unknowns;
    Eigen::VectorXd r;
};

Vec2 mean_move(const Unknowns& unknowns, const Eigen::VectorXd& step) {
    const auto junctions = static_cast<Eigen::Index>(unknowns.junctions.size());
    return step.head(2 * junctions).reshaped(2, junctions).rowwise().mean();
}

// Returns H s + r, the residual of the linear system after a step s. H is the Hessian of the foam
// without regularization.
Eigen::VectorXd linear_residual(const Case& c, const Eigen::VectorXd& step) {
    Hessian hessian(c.foam.network, c.unknowns);
    return hessian.evaluate(c.foam).selfadjointView<Eigen::Lower>() * step + c.r;
}

// A system of 180 unknowns uses double precision; the regularization of 1e-7 limits its accuracy.
TEST(NewtonSystem, SolvesWithTheHessian) {
    Case c(6);
    NewtonSystem system;
    system.start(c.foam, c.unknowns, 1);
    const Eigen::VectorXd step = system.step(c.foam, c.r);
    EXPECT_LT(linear_residual(c, step).norm(), 1e-6 * c.r.norm());
}

// A system of 720 unknowns uses single precision. Newton's method evaluates the residual in double
// precision before each step, so that a step also corrects the error of the step before. What
// matters is therefore the factor by which a step reduces the residual of the linear system (the
// forcing term of an inexact Newton method; Dembo, Eisenstat and Steihaug 1982). Two steps with one
// factor must reduce it by 1e-6, that is, each of them by 1e-3 in the geometric mean.
TEST(NewtonSystem, CorrectsErrorsOfSinglePrecisionInTheNextStep) {
    Case c(12);
    NewtonSystem system;
    system.start(c.foam, c.unknowns, 1);
    Eigen::VectorXd step = system.step(c.foam, c.r);
    EXPECT_LT(linear_residual(c, step).norm(), 3e-3 * c.r.norm());
    step += system.step(c.foam, linear_residual(c, step));
    EXPECT_LT(linear_residual(c, step).norm(), 1e-6 * c.r.norm());
}

TEST(NewtonSystem, DoesNotMoveTheWholeFoam) {
    for (const int side : {6, 12}) {
        Case c(side);
        NewtonSystem system;
        system.start(c.foam, c.unknowns, 1);
        EXPECT_LT(mean_move(c.unknowns, system.step(c.foam, c.r)).norm(), 1e-15);
    }
}

TEST(NewtonSystem, MovesAPartAsItIsPulled) {
    Case c(6);
    const std::vector<BubbleId> bubble{BubbleId{7}};
    const Unknowns part = unknowns_around(c.foam.network, bubble);
    NewtonSystem system;
    system.start(c.foam, part, 1);
    const Eigen::VectorXd step = system.step(c.foam, residual(c.foam, part));
    EXPECT_EQ(step.size(), 6 * 2 + 1);
    EXPECT_GT(mean_move(part, step).norm(), 1e-3);
}

TEST(NewtonSystem, KeepsAFactorUntilItIsDropped) {
    Case c(6);
    NewtonSystem system;
    system.start(c.foam, c.unknowns, 1);
    EXPECT_FALSE(system.has_factor());
    const Eigen::VectorXd first = system.step(c.foam, c.r);
    EXPECT_TRUE(system.has_factor());
    Foam moved = c.foam;
    moved.positions[JunctionId{0}] += Vec2(0.02, 0.0);
    EXPECT_EQ(system.step(moved, c.r),
              first);  // the chord method uses the factor of the earlier state
    system.drop_factor();
    EXPECT_FALSE(system.has_factor());
    EXPECT_NE(system.step(moved, c.r), first);
    EXPECT_TRUE(system.has_factor());
    system.start(c.foam, c.unknowns, 1);
    EXPECT_FALSE(system.has_factor());
    EXPECT_EQ(system.step(c.foam, c.r), first);
}

TEST(NewtonSystem, RaisesThePrecisionOnce) {
    Case large(12);
    NewtonSystem system;
    system.start(large.foam, large.unknowns, 1);
    const Eigen::VectorXd single = system.step(large.foam, large.r);
    EXPECT_TRUE(system.raise_precision(large.foam));
    EXPECT_FALSE(system.has_factor());
    const Eigen::VectorXd twice = system.step(large.foam, large.r);
    EXPECT_LT(linear_residual(large, twice).norm(), 0.1 * linear_residual(large, single).norm());
    EXPECT_FALSE(system.raise_precision(large.foam));
    EXPECT_TRUE(system.has_factor());
    Case small(6);  // double precision from the start
    system.start(small.foam, small.unknowns, 1);
    EXPECT_FALSE(system.raise_precision(small.foam));
}

TEST(NewtonSystem, GivesTheSameBitsForAnyNumberOfThreads) {
    Case c(12);
    NewtonSystem system;
    system.start(c.foam, c.unknowns, 1);
    const Eigen::VectorXd one = system.step(c.foam, c.r);
    for (const int threads : {0, 2, 3}) {
        system.start(c.foam, c.unknowns, threads);
        EXPECT_EQ(system.step(c.foam, c.r), one) << threads;
    }
}

// The second start of the same connections keeps the factor, so that its step is the one of the
// state before.
TEST(NewtonSystem, KeepsTheFactorOfTheSameConnections) {
    Case c(6);
    NewtonSystem system;
    system.start_whole(c.foam, 1);
    EXPECT_FALSE(system.has_factor());
    const Eigen::VectorXd step = system.step(c.foam, c.r);
    Foam moved = c.foam;
    moved.positions[JunctionId{3}] += Vec2(0.02, -0.01);
    system.start_whole(moved, 1);
    EXPECT_TRUE(system.has_factor());
    EXPECT_EQ(system.step(moved, c.r), step);
    system.drop_factor();
    EXPECT_NE(system.step(moved, c.r), step);
}

TEST(NewtonSystem, StartsAgainWithOtherConnections) {
    Case c(6);
    NewtonSystem system;
    system.start_whole(c.foam, 1);
    system.step(c.foam, c.r);
    flip(c.foam.network, FilmId{5});
    c.r = residual(c.foam, c.unknowns);
    system.start_whole(c.foam, 1);
    EXPECT_FALSE(system.has_factor());
    const Eigen::VectorXd step = system.step(c.foam, c.r);
    EXPECT_LT(linear_residual(c, step).norm(), 1e-5 * c.r.norm());
}

}  // namespace
}  // namespace foam
