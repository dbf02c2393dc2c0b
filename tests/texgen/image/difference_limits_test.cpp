// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/difference_limits.h"

#include <gtest/gtest.h>

#include <limits>

namespace foam::texgen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Without this rule, --fail-rms 0.01 would fail for every difference, because the limit of samples
// is 1e-6.
TEST(DifferenceLimits, OtherLimitsReplaceTheDefaultOfSamples) {
    EXPECT_EQ(DifferenceLimits().sample_limit(false), kDefaultSampleLimit);
    EXPECT_EQ(DifferenceLimits{.rms = 0.1}.sample_limit(false), kInfinity);
    EXPECT_EQ((DifferenceLimits{.percentiles = {{99.0, 0.1}}}.sample_limit(false)), kInfinity);
    EXPECT_EQ((DifferenceLimits{.sample = 0.5, .rms = 0.1}.sample_limit(false)), 0.5);
}

TEST(DifferenceLimits, AnAngleReplacesTheDefaultOnlyForNormals) {
    EXPECT_EQ(DifferenceLimits{.angle = 1.0}.sample_limit(true), kInfinity);
    EXPECT_EQ(DifferenceLimits{.angle = 1.0}.sample_limit(false), kDefaultSampleLimit);
}

// As in idiff, a hard limit is an addition to the limit of samples.
TEST(DifferenceLimits, AHardLimitKeepsTheDefault) {
    EXPECT_EQ(DifferenceLimits{.hard = 0.5}.sample_limit(false), kDefaultSampleLimit);
}

TEST(DifferenceLimits, TheLargerAllowanceCounts) {
    EXPECT_EQ(DifferenceLimits().allowed_of(100), 0U);
    EXPECT_EQ(DifferenceLimits{.allowed_percent = 1.0}.allowed_of(1000), 10U);
    EXPECT_EQ((DifferenceLimits{.allowed_percent = 1.0, .allowed_pixels = 12}.allowed_of(1000)),
              12U);
    EXPECT_EQ((DifferenceLimits{.allowed_percent = 1.0, .allowed_pixels = 9}.allowed_of(1000)),
              10U);
    EXPECT_EQ(DifferenceLimits{.allowed_percent = 1.0}.allowed_of(99), 0U);
}

// One pixel in a million, and 29 / 100.0 * 100, which is 28.999999999999996 in doubles.
TEST(DifferenceLimits, RoundingTakesNoPixelAway) {
    EXPECT_EQ(DifferenceLimits{.allowed_percent = 0.0001}.allowed_of(1'000'000), 1U);
    EXPECT_EQ(DifferenceLimits{.allowed_percent = 29.0}.allowed_of(100), 29U);
    EXPECT_EQ(DifferenceLimits{.allowed_percent = 100.0}.allowed_of(7), 7U);
}

}  // namespace
}  // namespace foam::texgen
