// SPDX-License-Identifier: Apache-2.0

#include "core/foam/frame.h"
#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"
#include "texgen/raster/distance/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr DistanceNeeds kAll{.gradient = true, .smooth = SmoothImages::DistanceAndGradient};
constexpr double kTolerance = 2e-5;

RasterGrid grid_of(int width, int height, const Vec2& center, double scale) {
    return {width, height, 0, 0, View{center, scale}};
}

Vec2 pair_at(const Image<float>& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {pixel[0], pixel[1]};
}

void expect_nearest(const Frame& frame, const RasterGrid& grid) {
    const DistanceField field = distance_field(frame, grid, kAll, 1);
    const test::NearestFilms films(frame, *grid.view, grid.width, grid.height);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const Vec2 center(x + 0.5, y + 0.5);
            const test::NearestFilms::Nearest nearest = films.at(center);
            const double distance = field.distance.pixel(x, y)[0];
            ASSERT_NEAR(distance, nearest.distance, kTolerance * (1.0 + 0.01 * distance))
                << x << ", " << y;
            const Vec2 gradient = pair_at(field.gradient, x, y);
            ASSERT_LT(films.at(center - distance * gradient).distance,
                      kTolerance * (1.0 + 0.01 * distance))
                << x << ", " << y;
        }
    }
}

// Expects that the bubble of each pixel covers a part of the pixel.
void expect_ids(const Frame& frame, const RasterGrid& grid) {
    const DistanceField field = distance_field(frame, grid, {}, 2);
    const test::SampledCoverage sampled =
        test::sample_coverage(frame, *grid.view, grid.width, grid.height, 0.0);
    std::size_t k = 0;
    for (const std::uint32_t id : field.ids.samples()) {
        ASSERT_GT(sampled.parts[k++][id], 0.0);
    }
}

TEST(DistanceInPatches, IsThatOfTheNearestFilmOfAll) {
    const Frame disc = snapshot(test::patch_foam(30, 3), 1);
    expect_nearest(disc, grid_of(90, 70, {0.0, 0.0}, 10.0));
    expect_nearest(disc, grid_of(64, 64, {1.7, -0.6}, 40.0));
    expect_nearest(disc, grid_of(40, 40, {9.0, 3.0}, 7.0));
    const Frame ring = snapshot(test::ring_foam(), 1);
    expect_nearest(ring, grid_of(90, 90, {0.0, 0.0}, 16.0));
    expect_ids(ring, grid_of(40, 40, {0.0, 0.0}, 7.0));
    expect_ids(disc, grid_of(40, 40, {0.3, 0.0}, 5.0));
}

TEST(DistanceInPatches, HoldsForAFewBubblesWithWideArcs) {
    for (const int bubbles : {2, 3, 4}) {
        const Frame frame = snapshot(test::patch_foam(bubbles, 7), 1);
        expect_nearest(frame, grid_of(70, 60, {0.0, 0.0}, 14.0));
        expect_ids(frame, grid_of(30, 30, {0.0, 0.0}, 8.0));
    }
}

// For a circle of radius r around c, the distance at p is |r - |p - c||. The smooth distance inside
// is (r² - |p - c|²) / 2r.
TEST(DistanceInPatches, OfLoneBubblesIsKnown) {
    const double area = 4.0;
    const Frame frame =
        snapshot(test::circles({{0, {-2.0, 0.1}, area}, {1, {1.5, 0.27}, area}}), 1);
    const double scale = 20.0;
    const RasterGrid grid = grid_of(200, 120, {0.0, 0.0}, scale);
    const DistanceField field = distance_field(frame, grid, kAll, 1);
    const double radius = scale * std::sqrt(area / std::numbers::pi);
    const auto ghost = static_cast<std::uint32_t>(index_of(frame.network.ghost()));
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const Vec2 p = Vec2(x + 0.5, y + 0.5) - Vec2(100.0, 60.0);
            const Vec2 left = p - scale * Vec2(-2.0, 0.1);
            const Vec2 right = p - scale * Vec2(1.5, 0.27);
            const bool is_left = left.norm() < right.norm();
            const Vec2 out = is_left ? left : right;
            const std::uint32_t id = out.norm() >= radius ? ghost : ghost + (is_left ? 1 : 2);
            ASSERT_EQ(field.ids.pixel(x, y)[0], id);
            const double distance = std::abs(radius - out.norm());
            ASSERT_NEAR(field.distance.pixel(x, y)[0], distance, kTolerance);
            const double power = (radius * radius - out.squaredNorm()) / (2.0 * radius);
            const double smooth = id == ghost ? distance : power;
            ASSERT_NEAR(field.smooth.pixel(x, y)[0], smooth, kTolerance);
            const Vec2 slope = id == ghost ? Vec2(out.normalized()) : Vec2(-out / radius);
            ASSERT_LT((pair_at(field.smooth_gradient, x, y) - slope).norm(), 1e-4)
                << x << ", " << y;
        }
    }
}

TEST(DistanceInPatches, IsInfiniteWithoutAnyFilm) {
    const Frame frame = snapshot(test::circles({}), 1);
    const DistanceField field = distance_field(frame, grid_of(20, 10, {0.0, 0.0}, 1.0), kAll, 2);
    for (const float distance : field.distance.samples()) {
        ASSERT_EQ(distance, std::numeric_limits<float>::infinity());
    }
    for (const float slope : field.gradient.samples()) {
        ASSERT_EQ(slope, 0.0F);
    }
}

// Returns the largest error of the gradient of the smooth distance along an axis, over the pixels
// of bubbles that are more than a pixel away from films. The reference is the difference of two
// views that are displaced by a twentieth of a pixel to either side.
double slope_error(const Frame& frame, int axis) {
    constexpr double kScale = 15.0;
    constexpr double kStep = 0.05;
    const auto field = [&](double pixels) {
        const Vec2 center = pixels / kScale * Vec2::Unit(axis);
        return distance_field(frame,
                              grid_of(80, 80, center, kScale),
                              {.smooth = SmoothImages::DistanceAndGradient},
                              1);
    };
    const DistanceField here = field(0.0);
    const DistanceField ahead = field(kStep);
    const DistanceField behind = field(-kStep);
    double largest = 0.0;
    for (std::size_t k = 0; k < here.ids.samples().size(); ++k) {
        if (here.ids.samples()[k] < frame.bubbles.size() && here.distance.samples()[k] > 1.0F) {
            const double difference = ahead.smooth.samples()[k] - behind.smooth.samples()[k];
            const double slope = here.smooth_gradient.samples()[2 * k + (axis == 0 ? 0 : 1)];
            largest = std::max(largest, std::abs(slope - difference / (2.0 * kStep)));
        }
    }
    return largest;
}

TEST(DistanceInPatches, HaveTheGradientsOfTheirSmoothDistance) {
    const Frame frame = snapshot(test::patch_foam(12, 5), 1);
    EXPECT_LT(slope_error(frame, 0), 2e-3);
    EXPECT_LT(slope_error(frame, 1), 2e-3);
}

// Around a patch, smooth distances equal the distances, which are then computed, too.
TEST(DistanceInPatches, SmoothDistancesDoNotDependOnDistances) {
    const Frame frame = snapshot(test::patch_foam(40, 9), 1);
    const RasterGrid grid = grid_of(400, 400, {0.2, 0.1}, 40.0);
    DistanceNeeds needs = kAll;
    const DistanceField all = distance_field(frame, grid, needs, 1);
    needs.distance = needs.gradient = false;
    const DistanceField some = distance_field(frame, grid, needs, 1);
    EXPECT_EQ(some.ids, all.ids);
    EXPECT_EQ(some.smooth, all.smooth);
    EXPECT_EQ(some.smooth_gradient, all.smooth_gradient);
}

TEST(DistanceInPatches, IsTheSameForAnyThreads) {
    const Frame frame = snapshot(test::patch_foam(40, 9), 1);
    const RasterGrid grid = grid_of(400, 400, {0.2, 0.1}, 40.0);
    const DistanceField one = distance_field(frame, grid, kAll, 1);
    const DistanceField three = distance_field(frame, grid, kAll, 3);
    EXPECT_EQ(one.ids, three.ids);
    EXPECT_EQ(one.distance, three.distance);
    EXPECT_EQ(one.gradient, three.gradient);
    EXPECT_EQ(one.smooth, three.smooth);
    EXPECT_EQ(one.smooth_gradient, three.smooth_gradient);
}

}  // namespace
}  // namespace foam::texgen
