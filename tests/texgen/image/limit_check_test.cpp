// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/limit_check.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Reasons = std::vector<std::string>;

/// Returns the judgment of 1000 pixels. Pixel k differs by k / 1000, so that the largest difference
/// is 0.999. `limits` are the limits of a failure; there are no warnings.
Comparison judged(const DifferenceLimits& limits, double rms = 0.0) {
    std::vector<double> differences(1000);
    for (std::size_t k = 0; k < differences.size(); ++k) {
        differences[k] = static_cast<double>(k) / 1000.0;
    }
    Comparison found;
    found.largest = 0.999;
    found.rms = rms;
    judge({differences, {}}, {.warn = {.sample = 1.0}, .fail = limits}, found);
    return found;
}

// 99.9 % of 1000 pixels are the 999 pixels that differ by at most 0.998.
TEST(LimitCheck, PercentilesAreDifferencesOfPixels) {
    std::vector<double> differences(1000);
    std::iota(differences.rbegin(), differences.rend(), 0.0);
    EXPECT_EQ(percentile_of(differences, 99.9), 998.0);
    EXPECT_EQ(percentile_of(differences, 100.0), 999.0);
    EXPECT_EQ(percentile_of(differences, 0.1), 0.0);
    EXPECT_EQ(percentile_of(differences, 50.0), 499.0);
    EXPECT_EQ(percentile_of(differences, 50.01), 500.0);
    EXPECT_EQ(percentile_of(std::vector<double>{7.0}, 0.001), 7.0);
    EXPECT_EQ(judged({}).percentile, 0.998);
}

TEST(LimitCheck, SomePixelsMayBeAboveTheLimit) {
    EXPECT_EQ(judged({.sample = 0.989}).failure_pixels, 10U);
    EXPECT_EQ(judged({.sample = 0.989}).reasons, Reasons{"10 of 1000 pixels above 0.989"});
    EXPECT_EQ(judged({.sample = 0.989, .allowed_percent = 1.0}).verdict, Verdict::Same);
    EXPECT_EQ(judged({.sample = 0.989, .allowed_pixels = 10}).verdict, Verdict::Same);
    EXPECT_EQ(judged({.sample = 0.989, .allowed_percent = 0.95}).reasons,
              Reasons{"10 of 1000 pixels above 0.989 although only 9 are allowed"});
}

TEST(LimitCheck, AHardLimitHoldsForAllPixels) {
    EXPECT_EQ(judged({.sample = 0.5, .allowed_percent = 100.0, .hard = 0.999}).verdict,
              Verdict::Same);
    EXPECT_EQ(judged({.sample = 0.5, .allowed_percent = 100.0, .hard = 0.998}).reasons,
              Reasons{"largest difference 0.999 above 0.998"});
}

TEST(LimitCheck, ChecksTheRmsAndPercentiles) {
    EXPECT_EQ(judged({.rms = 0.5}, 0.5).verdict, Verdict::Same);
    EXPECT_EQ(judged({.rms = 0.5}, 0.625).reasons, Reasons{"rms 0.625 above 0.5"});
    EXPECT_EQ(judged({.percentiles = {{99.9, 0.998}}}).verdict, Verdict::Same);
    EXPECT_EQ(judged({.percentiles = {{50.0, 0.499}, {99.9, 0.99}}}).reasons,
              Reasons{"percentile 99.9 = 0.998 above 0.99"});
}

TEST(LimitCheck, APixelIsAboveTheLimitsByItsDifferenceOrItsAngle) {
    const std::vector<double> differences = {0.0, 0.2, 0.2, 0.4};
    const std::vector<double> angles = {0.0, 3.0, 1.0, 1.0};
    const auto reasons = [&](const DifferenceLimits& limits) {
        Comparison found;
        judge({differences, angles}, {.warn = {.sample = 1.0}, .fail = limits}, found);
        return found.reasons;
    };
    EXPECT_EQ(reasons({.angle = 2.0}), Reasons{"1 of 4 pixels above 2 degrees"});
    EXPECT_EQ(reasons({.sample = 0.3, .angle = 2.0}),
              Reasons{"2 of 4 pixels above 0.3 or 2 degrees"});
    EXPECT_EQ(reasons({.angle = 2.0, .allowed_pixels = 1}), Reasons{});
}

TEST(LimitCheck, WarningsAreNotedWithoutFailures) {
    Comparison found;
    const std::vector<double> differences = {0.0, 0.2};
    judge({differences, {}}, {.warn = {.sample = 0.1}, .fail = {.sample = 0.3}}, found);
    EXPECT_EQ(found.verdict, Verdict::Warning);
    EXPECT_EQ(found.reasons, Reasons{"1 of 2 pixels above 0.1"});
    EXPECT_EQ(found.warning_pixels, 1U);
    EXPECT_EQ(found.failure_pixels, 0U);
}

}  // namespace
}  // namespace foam::texgen
