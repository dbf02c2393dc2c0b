// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/domain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace foam {
namespace {

constexpr Domain kTorus{3.0, 0.7};

Vec2 wrapped(const Domain& domain, const Vec2& point) {
    return point - domain.translation(domain.cell_of(point));
}

TEST(Domain, HasAnAreaAndTranslatesByPeriods) {
    EXPECT_DOUBLE_EQ(kTorus.area(), 2.1);
    EXPECT_EQ(kTorus.translation({2, -1}), Vec2(6.0, -0.7));
}

TEST(Domain, NothingWrapsInThePlane) {
    EXPECT_TRUE(kPlane.is_plane());
    EXPECT_FALSE(kTorus.is_plane());
    for (const Vec2& point : {Vec2(0.0, 0.0), Vec2(-1e9, 3.5), Vec2(7.0, -1e-300)}) {
        EXPECT_TRUE(kPlane.cell_of(point) == LatticeOffset{});
        EXPECT_EQ(wrapped(kPlane, point), point);
    }
}

TEST(Domain, OffsetsAddUp) {
    const LatticeOffset a{2, -3};
    const LatticeOffset b{-5, 1};
    EXPECT_TRUE(a + b == (LatticeOffset{-3, -2}));
    EXPECT_TRUE(a - b == (LatticeOffset{7, -4}));
    EXPECT_TRUE(-a == (LatticeOffset{-2, 3}));
    EXPECT_FALSE(a == b);
}

TEST(Domain, FindsTheCellOfPointsInEachDirection) {
    EXPECT_TRUE(kTorus.cell_of({0.0, 0.0}) == (LatticeOffset{0, 0}));
    EXPECT_TRUE(kTorus.cell_of({2.9, 0.6}) == (LatticeOffset{0, 0}));
    EXPECT_TRUE(kTorus.cell_of({3.1, -0.1}) == (LatticeOffset{1, -1}));
    EXPECT_TRUE(kTorus.cell_of({-6.1, 1.5}) == (LatticeOffset{-3, 2}));
}

TEST(Domain, PointsWithoutACellAreNotMoved) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(kTorus.cell_of({nan, 0.1}) == (LatticeOffset{0, 0}));
    EXPECT_TRUE(kTorus.cell_of({0.1, nan}) == (LatticeOffset{0, 0}));
    EXPECT_TRUE(kTorus.cell_of({1e300, 0.1}) == (LatticeOffset{0, 0}));
    EXPECT_TRUE(kTorus.cell_of({-0.1, -std::numeric_limits<double>::infinity()}) ==
                (LatticeOffset{-1, 0}));
}

TEST(Domain, AWholePeriodBelongsToTheNextCell) {
    EXPECT_TRUE(kTorus.cell_of({3.0, 0.7}) == (LatticeOffset{1, 1}));
    EXPECT_TRUE(kTorus.cell_of({-3.0, -0.7}) == (LatticeOffset{-1, -1}));
    EXPECT_EQ(wrapped(kTorus, {-3.0, -0.7}), Vec2(0.0, 0.0));
    EXPECT_EQ(wrapped(kTorus, {3.0, 0.7}), Vec2(0.0, 0.0));
}

TEST(Domain, TheLastPointBeforeAPeriodStays) {
    const Vec2 last(std::nextafter(3.0, 0.0), std::nextafter(0.7, 0.0));
    EXPECT_TRUE(kTorus.cell_of(last) == (LatticeOffset{0, 0}));
}

TEST(Domain, ATinyNegativeWraps) {
    EXPECT_TRUE(kTorus.cell_of({-1e-12, -1e-12}) == (LatticeOffset{-1, -1}));
    EXPECT_LT(wrapped(kTorus, {-1e-12, 0.1}).x(), 3.0);
}

// -1e-20 plus a period is rounded to a period, which is also outside of the cell. No translation
// moves the point into the cell, so it stays where it is, outside by far less than a rounding
// error.
TEST(Domain, ANegativeBelowRoundingStays) {
    EXPECT_TRUE(kTorus.cell_of({-1e-20, -1e-20}) == (LatticeOffset{0, 0}));
}

// Coordinates are multiples of a seventh of the period, up to 1e5 periods away. They include whole
// periods, where k * period is rounded.
RC_GTEST_PROP(Domain, WrappedPointsLieInTheCell, ()) {
    const double width = *rc::gen::inRange(1, 1000) / 7.0;
    const double height = *rc::gen::inRange(1, 1000) / 7.0;
    const Domain domain{width, height};
    const Vec2 point(width * *rc::gen::inRange(-700000, 700000) / 7.0,
                     height * *rc::gen::inRange(-700000, 700000) / 7.0);
    const Vec2 inside = wrapped(domain, point);
    RC_ASSERT(inside.x() >= 0.0);
    RC_ASSERT(inside.x() < width);
    RC_ASSERT(inside.y() >= 0.0);
    RC_ASSERT(inside.y() < height);
}

RC_GTEST_PROP(Domain, CellOfShiftsWithThePoint, ()) {
    // Powers of two, so that whole periods add without rounding.
    const Domain domain{4.0, 0.5};
    const Vec2 point(*rc::gen::inRange(-4000, 4000) / 256.0,
                     *rc::gen::inRange(-4000, 4000) / 256.0);
    const LatticeOffset shift{*rc::gen::inRange(-99, 99), *rc::gen::inRange(-99, 99)};
    RC_ASSERT(domain.cell_of(point + domain.translation(shift)) == domain.cell_of(point) + shift);
}

}  // namespace
}  // namespace foam
