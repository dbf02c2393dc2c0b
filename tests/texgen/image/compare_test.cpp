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
    const Comparison found = compare(a, b, {.warn = {.sample = 0.1}, .fail = {.sample = 0.3}});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, 0.5);
    EXPECT_EQ(found.mean, 0.75 / 6.0);
    EXPECT_DOUBLE_EQ(found.rms, std::sqrt((0.0625 + 0.25) / 6.0));
    EXPECT_EQ(found.percentile, 0.5);
    EXPECT_EQ(found.pixels, 6U);
    EXPECT_EQ(found.warning_pixels, 2U);
    EXPECT_EQ(found.failure_pixels, 1U);
    EXPECT_FALSE(found.angle.has_value());
    EXPECT_EQ(found.reasons, std::vector<std::string>{"1 of 6 pixels above 0.3"});
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
    const auto verdict = [&](double warn, double fail) {
        return compare(a, b, {.warn = {.sample = warn}, .fail = {.sample = fail}}).verdict;
    };
    EXPECT_EQ(verdict(0.5, 0.5), Verdict::Same);
    EXPECT_EQ(verdict(0.1, 0.5), Verdict::Warning);
    EXPECT_EQ(verdict(0.1, 0.4), Verdict::Failure);
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
    const Comparison found =
        compare(a, gray({0, infinity, 0, 0, 0, 0}), {.warn = {}, .fail = {.sample = 1e30}});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, infinity);
}

/// Returns a picture of one pixel with the given normal.
Picture normal(float x, float y, float z) {
    Image<float> image(1, 1, 3);
    std::ranges::copy(std::vector<float>{x, y, z}, image.samples().begin());
    return {{{{"X", "Y", "Z"}, SampleType::Float, image}}};
}

// The normals are 45 degrees apart. A limit of angles replaces the default limit of samples, but
// only for pictures of normals.
TEST(Compare, MeasuresAnglesOfNormals) {
    const Picture a = normal(0.0F, 0.0F, 1.0F);
    const Picture b = normal(1.0F, 0.0F, 1.0F);
    const auto compared = [&](double angle, PixelContent content) {
        return compare(a, b, {.warn = {.sample = 1.0}, .fail = {.angle = angle}}, content);
    };
    const Comparison far = compared(44.0, PixelContent::Normals);
    EXPECT_NEAR(far.angle.value(), 45.0, 1e-12);
    EXPECT_EQ(far.verdict, Verdict::Failure);
    EXPECT_EQ(far.reasons, std::vector<std::string>{"1 of 1 pixels above 44 degrees"});
    EXPECT_EQ(compared(46.0, PixelContent::Normals).verdict, Verdict::Same);
    EXPECT_EQ(compared(46.0, PixelContent::Numbers).verdict, Verdict::Failure);
    const Picture gray_picture = gray({0, 0, 0, 0, 0, 0});
    EXPECT_FALSE(compare(gray_picture, gray_picture, {}, PixelContent::Normals).angle.has_value());
}

// The largest angle is in the upper right pixel of 2 x 2 pixels.
TEST(Compare, ReportsThePositionOfTheLargestAngle) {
    Image<float> flat(2, 2, 3);
    for (int k = 0; k < 4; ++k) {
        flat.pixel(k % 2, k / 2)[2] = 1.0F;
    }
    Image<float> turned = flat;
    turned.pixel(0, 0)[0] = 0.1F;
    turned.pixel(1, 1)[0] = 0.2F;
    const Comparison found = compare({{{{"X", "Y", "Z"}, SampleType::Float, flat}}},
                                     {{{{"X", "Y", "Z"}, SampleType::Float, turned}}},
                                     {},
                                     PixelContent::Normals);
    EXPECT_EQ(found.angle_x, 1);
    EXPECT_EQ(found.angle_y, 0);
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
