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

TEST(ArcDistance, IsTheDistanceToTheNearestPointOfTheArc) {
    for (const double half_angle : {-2.9, -1.6, -0.7, -0.01, 0.02, 0.9, 1.5, 2.0, 3.0}) {
        const FilmArc arc{{12.0, 5.0}, half_angle};
        for (const Vec2& point : {Vec2(3.0, 9.0),
                                  Vec2(-4.0, 1.0),
                                  Vec2(15.0, 2.0),
                                  Vec2(6.0, 2.5),
                                  Vec2(7.0, -8.0),
                                  Vec2(-20.0, 30.0)}) {
            EXPECT_NEAR(
                nearest_on_arc(pixel_arc(arc), point).distance, sampled_distance(arc, point), 1e-6)
                << "half angle " << half_angle << ", point " << point.transpose();
        }
    }
}

TEST(ArcDistance, IsExactForAStraightLine) {
    const PixelArc line{{10.0, 0.0}, 1.0, 0.0};
    EXPECT_EQ(nearest_on_arc(line, {4.0, 3.0}).distance, 3.0);
    EXPECT_EQ(nearest_on_arc(line, {4.0, -3.0}).distance, 3.0);
    EXPECT_EQ(nearest_on_arc(line, {13.0, 4.0}).distance, 5.0);
    EXPECT_EQ(nearest_on_arc(line, {-3.0, -4.0}).distance, 5.0);
}

TEST(ArcDistance, AnArcWithoutLengthIsAPoint) {
    EXPECT_EQ(nearest_on_arc({{0.0, 0.0}, 1.0, 0.0}, {3.0, 4.0}).distance, 5.0);
    EXPECT_EQ(nearest_on_arc({{0.0, 0.0}, 1.0, 0.0}, {0.0, 0.0}).distance, 0.0);
}

// The derivative of a distance along a direction is the product of the direction and the gradient.
TEST(ArcDistance, DirectionIsThatOfTheGradient) {
    constexpr double kStep = 1e-6;
    for (const double half_angle : {-2.9, -0.7, -0.01, 0.0, 0.9, 1.5, 3.0}) {
        const PixelArc arc = pixel_arc({{12.0, 5.0}, half_angle});
        for (const Vec2& point :
             {Vec2(3.0, 9.0), Vec2(-4.0, 1.0), Vec2(15.0, 2.0), Vec2(7.0, -8.0)}) {
            const auto distance = [&](double x, double y) {
                return nearest_on_arc(arc, point + Vec2(x, y)).distance;
            };
            const Vec2 slopes(distance(kStep, 0.0) - distance(-kStep, 0.0),
                              distance(0.0, kStep) - distance(0.0, -kStep));
            const Vec2 gradient = nearest_on_arc(arc, point).direction.normalized();
            EXPECT_LT((gradient - slopes / (2.0 * kStep)).norm(), 1e-6)
                << "half angle " << half_angle << ", point " << point.transpose();
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
