// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a picture of 3 x 2 pixels with one channel. The first number is the lower left pixel.
Picture gray(const std::vector<double>& numbers, const std::string& name = "Y") {
    Image<float> image(3, 2, 1);
    std::ranges::transform(
        numbers, image.samples().begin(), [](double number) { return static_cast<float>(number); });
    return {{{{name}, SampleType::Float, image}}};
}

// Computed by hand: two of the six samples differ, by 0.25 and by 0.5.
TEST(Compare, MeasuresDifferences) {
    const Picture a = gray({0, 0, 0, 1, 1, 1});
    const Picture b = gray({0, 0.25, 0, 1, 1, 0.5});
    const Comparison found = compare(a, b, {.warn = 0.1, .fail = 0.3});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, 0.5);
    EXPECT_EQ(found.mean, 0.75 / 6.0);
    EXPECT_EQ(found.warnings, 2U);
    EXPECT_EQ(found.failures, 1U);
    EXPECT_EQ(found.channel, "Y");
    EXPECT_EQ(found.x, 2);
    EXPECT_EQ(found.y, 0);
}

// A difference equal to a limit is still allowed.
TEST(Compare, VerdictFollowsTheLimits) {
    const Picture a = gray({0, 0, 0, 0, 0, 0});
    const Picture b = gray({0.5, 0, 0, 0, 0, 0});
    EXPECT_EQ(compare(a, a).verdict, Verdict::Same);
    EXPECT_EQ(compare(a, b).verdict, Verdict::Failure);
    EXPECT_EQ(compare(a, b, {.warn = 0.5, .fail = 0.5}).verdict, Verdict::Same);
    EXPECT_EQ(compare(a, b, {.warn = 0.1, .fail = 0.5}).verdict, Verdict::Warning);
    EXPECT_EQ(compare(a, b, {.warn = 0.1, .fail = 0.4}).verdict, Verdict::Failure);
}

TEST(Compare, OtherFormsAreNotCompared) {
    const Picture a = gray({0, 0, 0, 0, 0, 0});
    const Picture narrow = {{{{"Y"}, SampleType::Float, Image<float>(2, 2, 1)}}};
    Picture two = a;
    two.groups.push_back({{"Z"}, SampleType::Float, a.groups[0].samples});
    for (const Picture& b : {narrow, two, gray({0, 0, 0, 0, 0, 0}, "R")}) {
        EXPECT_EQ(compare(a, b).verdict, Verdict::DifferentLayout);
    }
}

TEST(Compare, NanDiffersFromNumbersOnly) {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    const Picture a = gray({nan, infinity, 0, 0, 0, 0});
    EXPECT_EQ(compare(a, a).verdict, Verdict::Same);
    const Comparison found = compare(a, gray({0, infinity, 0, 0, 0, 0}), {.fail = 1e30});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, infinity);
}

TEST(Compare, TheDifferencePictureShowsTheLargestAsWhite) {
    const Picture a = gray({0, 0, 0, 1, 1, 1});
    const Image<std::uint16_t> shown = difference_picture(a, gray({0, 0.25, 0, 1, 1, 0.5}));
    EXPECT_EQ(shown.row(0)[1], 32768);
    EXPECT_EQ(shown.row(1)[2], 65535);
    EXPECT_EQ(shown.row(0)[0], 0);
    const Image<std::uint16_t> black = difference_picture(a, a);
    EXPECT_EQ(std::ranges::count(black.samples(), 0), 6);
}

}  // namespace
}  // namespace foam::texgen
