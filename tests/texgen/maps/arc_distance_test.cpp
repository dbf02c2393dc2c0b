// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

// Returns the distance from a point to the nearest of many points of an arc.
double sampled_distance(const FilmArc& arc, const Vec2& point) {
    constexpr int kSamples = 200'000;
    const double radius = 0.5 * arc.chord.norm() / std::sin(arc.half_angle);
    const Vec2 center =
        0.5 * arc.chord + radius * std::cos(arc.half_angle) * turned_left(arc.chord.normalized());
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kSamples; ++k) {
        const double angle = 2.0 * arc.half_angle * k / kSamples;
        const Vec2 from_center = -center;
        const Vec2 at =
            center + std::cos(angle) * from_center + std::sin(angle) * turned_left(from_center);
        nearest = std::min(nearest, (point - at).norm());
    }
    return nearest;
}

// An image of one arc in the plane. The arc begins at the given position, in pixels.
ArcDistances distances_to_arc(const PixelArc& arc, const Vec2& tail, double reach) {
    constexpr int kSide = 48;
    const RasterGrid grid{kSide, kSide, 0, 0, View{Vec2::Constant(0.5 * kSide), 1.0}};
    const std::vector<PlacedArc> arcs = {{tail, arc}};
    return distances_to_arcs(arcs, grid, kPlane, {reach, true}, 2);
}

TEST(ArcDistance, IsTheDistanceToTheNearestPointOfTheArc) {
    const Vec2 tail(17.0, 19.0);
    for (const double half_angle : {-2.9, -1.6, -0.7, -0.01, 0.02, 0.9, 1.5, 2.0, 3.0}) {
        const FilmArc arc{{12.0, 5.0}, half_angle};
        const Image<float> image = distances_to_arc(pixel_arc(arc), tail, 100.0).distance;
        for (int y = 0; y < image.height(); y += 5) {
            for (int x = 0; x < image.width(); x += 5) {
                const Vec2 point = Vec2(x + 0.5, y + 0.5) - tail;
                EXPECT_NEAR(image.pixel(x, y)[0], sampled_distance(arc, point), 1e-4)
                    << "half angle " << half_angle << ", point " << point.transpose();
            }
        }
    }
}

TEST(ArcDistance, IsExactForAStraightLine) {
    const Image<float> image =
        distances_to_arc({{10.0, 0.0}, 1.0, 0.0}, {20.5, 20.5}, 100.0).distance;
    EXPECT_EQ(image.pixel(24, 23)[0], 3.0F);
    EXPECT_EQ(image.pixel(24, 17)[0], 3.0F);
    EXPECT_EQ(image.pixel(33, 24)[0], 5.0F);
    EXPECT_EQ(image.pixel(17, 16)[0], 5.0F);
}

TEST(ArcDistance, AnArcWithoutLengthIsAPoint) {
    const Image<float> image =
        distances_to_arc({{0.0, 0.0}, 1.0, 0.0}, {20.5, 20.5}, 100.0).distance;
    EXPECT_EQ(image.pixel(23, 24)[0], 5.0F);
    EXPECT_EQ(image.pixel(20, 20)[0], 0.0F);
}

TEST(ArcDistance, IsInfiniteBeyondTheReach) {
    const PixelArc arc = pixel_arc({{12.0, 5.0}, 0.9});
    const ArcDistances all = distances_to_arc(arc, {17.0, 19.0}, 100.0);
    const ArcDistances near = distances_to_arc(arc, {17.0, 19.0}, 6.5);
    for (int y = 0; y < near.distance.height(); ++y) {
        for (int x = 0; x < near.distance.width(); ++x) {
            const float distance = all.distance.pixel(x, y)[0];
            if (distance <= 6.5F) {
                EXPECT_EQ(near.distance.pixel(x, y)[0], distance);
                EXPECT_EQ(near.gradient.pixel(x, y)[0], all.gradient.pixel(x, y)[0]);
                EXPECT_EQ(near.gradient.pixel(x, y)[1], all.gradient.pixel(x, y)[1]);
            } else {
                EXPECT_EQ(near.distance.pixel(x, y)[0], std::numeric_limits<float>::infinity());
                EXPECT_EQ(near.gradient.pixel(x, y)[0], 0.0F);
                EXPECT_EQ(near.gradient.pixel(x, y)[1], 0.0F);
            }
        }
    }
}

// The gradient points away from the nearest of many points of the arc.
TEST(ArcDistance, GradientPointsAwayFromTheNearestPoint) {
    const Vec2 tail(17.0, 19.0);
    for (const double half_angle : {-2.9, -0.7, -0.01, 0.02, 0.9, 1.5, 3.0}) {
        const FilmArc arc{{12.0, 5.0}, half_angle};
        const ArcDistances image = distances_to_arc(pixel_arc(arc), tail, 100.0);
        for (int y = 2; y < image.distance.height(); y += 11) {
            for (int x = 2; x < image.distance.width(); x += 11) {
                const Vec2 point = Vec2(x + 0.5, y + 0.5) - tail;
                const double distance = sampled_distance(arc, point);
                const Vec2 gradient(image.gradient.pixel(x, y)[0], image.gradient.pixel(x, y)[1]);
                EXPECT_NEAR(gradient.norm(), 1.0, 1e-6);
                // Only the right gradient leads to the arc.
                EXPECT_LT(sampled_distance(arc, point - distance * gradient), 2e-3)
                    << "half angle " << half_angle << ", point " << point.transpose();
            }
        }
    }
}

// An arc through the corner of a torus is also near the other three corners of the image.
TEST(ArcDistance, ContinuesAcrossTheBordersOfATorus) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.0, 0.0}, {{2.0, 0.0}, 1.0, 0.0}}};
    const Image<float> image = distances_to_arcs(arcs, {32, 32}, domain, {4.0}, 1).distance;
    EXPECT_FLOAT_EQ(image.pixel(1, 0)[0], 0.5F);
    EXPECT_FLOAT_EQ(image.pixel(1, 31)[0], 0.5F);
    EXPECT_FLOAT_EQ(image.pixel(31, 0)[0], std::sqrt(0.5F));
    EXPECT_FLOAT_EQ(image.pixel(31, 31)[0], std::sqrt(0.5F));
    EXPECT_EQ(image.pixel(16, 16)[0], std::numeric_limits<float>::infinity());
}

// A line that crosses the image from end to end, 3 million pixels to each side, in a magnified view
// of a patch.
TEST(ArcDistance, MayBeginFarFromTheImage) {
    const std::vector<PlacedArc> arcs = {{{-3e6, 0.0}, {{6e6, 0.0}, 1.0, 0.0}}};
    const RasterGrid grid{8, 8, 0, 0, View{Vec2::Zero(), 1.0}};
    const Image<float> image = distances_to_arcs(arcs, grid, kPlane, {2.0}, 1).distance;
    EXPECT_EQ(image.pixel(0, 4)[0], 0.5F);
    EXPECT_EQ(image.pixel(7, 2)[0], 1.5F);
    EXPECT_EQ(image.pixel(0, 0)[0], std::numeric_limits<float>::infinity());
}

TEST(ArcDistance, DoesNotDependOnTheNumberOfThreads) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.1, 0.2}, {{70.0, 20.0}, 0.8, 0.6}},
                                         {{0.9, 0.6}, {{40.0, 90.0}, 0.6, -0.8}}};
    const ArcDistances one = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 1);
    const ArcDistances four = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 4);
    EXPECT_EQ(one.distance, four.distance);
    EXPECT_EQ(one.gradient, four.gradient);
}

TEST(ArcDistance, AShiftOfTheGridIsCyclicToTheBit) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.1, 0.2}, {{70.0, 20.0}, 0.8, 0.6}},
                                         {{0.9, 0.6}, {{40.0, 90.0}, 0.6, -0.8}}};
    const ArcDistances still = distances_to_arcs(arcs, {150, 150}, domain, {30.0, true}, 1);
    const ArcDistances shifted =
        distances_to_arcs(arcs, {150, 150, 37, -61}, domain, {30.0, true}, 1);
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 150; ++x) {
            const int from_x = (x + 37) % 150;
            const int from_y = (y - 61 + 150) % 150;
            EXPECT_EQ(shifted.distance.pixel(x, y)[0], still.distance.pixel(from_x, from_y)[0]);
            EXPECT_EQ(shifted.gradient.pixel(x, y)[0], still.gradient.pixel(from_x, from_y)[0]);
            EXPECT_EQ(shifted.gradient.pixel(x, y)[1], still.gradient.pixel(from_x, from_y)[1]);
        }
    }
}

TEST(ArcDistance, TheGradientIsOptional) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.1, 0.2}, {{70.0, 20.0}, 0.8, 0.6}}};
    const ArcDistances with = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 1);
    const ArcDistances without = distances_to_arcs(arcs, {160, 120}, domain, {30.0, false}, 1);
    EXPECT_EQ(with.distance, without.distance);
    EXPECT_EQ(with.gradient.width(), 160);
    EXPECT_TRUE(without.gradient.samples().empty());
}

// The sum of the coverage is the area of a stroke with round ends.
TEST(ArcDistance, StrokesHaveTheirArea) {
    const Domain domain{1.0, 1.0};
    for (const double width : {0.25, 1.0, 3.0, 9.5}) {
        const PixelArc line{{30.0, 17.0}, 1.0, 0.0};
        const std::vector<PlacedArc> arcs = {{{0.8, 0.7}, line}};
        const Image<float> image = stroke_coverage(
            distances_to_arcs(arcs, {96, 96}, domain, stroke_needs(width), 1).distance, width);
        double sum = 0.0;
        for (const float sample : image.samples()) {
            sum += static_cast<double>(sample);
        }
        const double wide = std::max(width, 1.0);
        const double area = std::min(width, 1.0) *
                            (wide * line.chord.norm() + 0.25 * std::numbers::pi * wide * wide);
        EXPECT_NEAR(sum, area, 0.01 * area + 0.2 * std::min(width, 1.0)) << width;
    }
}

}  // namespace
}  // namespace foam::texgen
