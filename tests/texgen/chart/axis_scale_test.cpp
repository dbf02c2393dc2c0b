#include "texgen/chart/axis_scale.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<std::string> labels(const AxisScale& scale) {
    std::vector<std::string> all;
    for (const Tick& tick : scale.ticks) {
        if (!tick.label.empty()) {
            all.push_back(tick.label);
        }
    }
    return all;
}

using Labels = std::vector<std::string>;

// 1047 / 7 = 150: the next of 1, 2, 5 times a power of ten is 200.
TEST(AxisScale, LinearEndsMoveOutToNiceTicks) {
    const AxisScale scale = axis_scale(AxisKind::Linear, 0.0, 1047.0);
    EXPECT_EQ(scale.low, 0.0);
    EXPECT_EQ(scale.high, 1200.0);
    EXPECT_EQ(labels(scale), (Labels{"0", "200", "400", "600", "800", "1,000", "1,200"}));
}

TEST(AxisScale, LinearLabelsHaveTheDecimalsOfTheStep) {
    EXPECT_EQ(labels(axis_scale(AxisKind::Linear, -0.031, 0.052)),
              (Labels{"-0.04", "-0.02", "0.00", "0.02", "0.04", "0.06"}));
    EXPECT_EQ(labels(axis_scale(AxisKind::Linear, 0.9, 1.4)),
              (Labels{"0.9", "1.0", "1.1", "1.2", "1.3", "1.4"}));
}

TEST(AxisScale, AnEndOnATickStays) {
    const AxisScale scale = axis_scale(AxisKind::Linear, 0.0, 0.7);  // 7 steps of 0.1
    EXPECT_NEAR(scale.high, 0.7, 1e-15);
    EXPECT_EQ(scale.ticks.size(), 8U);
}

TEST(AxisScale, LogarithmicAxesOfTwoDecadesLabelPowersOfTen) {
    const AxisScale scale = axis_scale(AxisKind::Logarithmic, 0.012, 39.5);
    EXPECT_NEAR(scale.low, 0.01, 1e-15);
    EXPECT_NEAR(scale.high, 50.0, 1e-12);
    EXPECT_EQ(labels(scale), (Labels{"0.01", "0.1", "1", "10"}));
    EXPECT_EQ(scale.ticks.size(), 9U + 9U + 9U + 5U);  // 0.01 ... 0.09, ..., 10 ... 50
}

TEST(AxisScale, ShortLogarithmicAxesLabelMore) {
    EXPECT_EQ(labels(axis_scale(AxisKind::Logarithmic, 130.0, 990.0)),
              (Labels{"100", "200", "500", "1,000"}));
}

TEST(AxisScale, EqualEndsGetSomeLength) {
    for (const AxisKind kind : {AxisKind::Linear, AxisKind::Logarithmic}) {
        const AxisScale scale = axis_scale(kind, 10.0, 10.0);
        EXPECT_LT(scale.low, scale.high);
        EXPECT_LE(scale.low, 10.0);
        EXPECT_GE(scale.high, 10.0);
    }
    EXPECT_EQ(axis_scale(AxisKind::Linear, 0.0, 0.0).low, -1.0);
}

TEST(AxisScale, FractionsRunFromEndToEnd) {
    const AxisScale linear = axis_scale(AxisKind::Linear, 0.0, 10.0);
    EXPECT_EQ(linear.fraction(2.5), 0.25);
    const AxisScale logarithmic = axis_scale(AxisKind::Logarithmic, 1.0, 10'000.0);
    EXPECT_NEAR(logarithmic.fraction(10.0), 0.25, 1e-15);
    EXPECT_NEAR(logarithmic.fraction(10'000.0), 1.0, 1e-15);
}

TEST(FormatTick, WritesNumbersAsPeopleDo) {
    EXPECT_EQ(format_tick(1234567.0, 0), "1,234,567");
    EXPECT_EQ(format_tick(-12000.5, 1), "-12,000.5");
    EXPECT_EQ(format_tick(999.0, 0), "999");
    EXPECT_EQ(format_tick(-0.0, 1), "0.0");
    EXPECT_EQ(format_tick(0.00001, 5), "1e-05");
    EXPECT_EQ(format_tick(2e7, 0), "2e+07");
}

// Any two values lie on the axis made for them, which begins and ends with a tick.
RC_GTEST_PROP(AxisScaleProperty, TakesInBothValues, ()) {
    const auto kind = *rc::gen::element(AxisKind::Linear, AxisKind::Logarithmic);
    const double a = std::exp(0.01 * *rc::gen::inRange(-2000, 2000));
    const double b = std::exp(0.01 * *rc::gen::inRange(-2000, 2000));
    const AxisScale scale = axis_scale(kind, std::min(a, b), std::max(a, b));
    RC_ASSERT(scale.fraction(std::min(a, b)) > -1e-6);
    RC_ASSERT(scale.fraction(std::max(a, b)) < 1.0 + 1e-6);
    RC_ASSERT(std::abs(scale.fraction(scale.ticks.front().value)) < 1e-6);
    RC_ASSERT(std::abs(scale.fraction(scale.ticks.back().value) - 1.0) < 1e-6);
    RC_ASSERT(scale.ticks.size() >= 2U);
    RC_ASSERT(kind == AxisKind::Logarithmic || scale.ticks.size() <= 11U);
}

}  // namespace
}  // namespace foam::texgen
