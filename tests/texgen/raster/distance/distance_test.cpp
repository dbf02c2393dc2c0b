// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/distance.h"

#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"
#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace foam::texgen {
namespace {

constexpr DistanceNeeds kAll{.gradient = true, .smooth = SmoothImages::DistanceAndGradient};
// The tolerances are in pixels. The outlines that decide ids are rounded to subpixels. If the
// distance of a pixel is at most kChainTolerance, the id may be that of the bubble on the other
// side of the film.
constexpr double kChainTolerance = 2e-3;
constexpr double kTolerance = 2e-5;

Vec2 pair_at(const Image<float>& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {pixel[0], pixel[1]};
}

// Compares the field with all films in all periodic copies. A step back along the gradient must
// lead to a film.
void expect_nearest(const Frame& frame, int width, int height, double tolerance = kTolerance) {
    const DistanceField field = distance_field(frame, {width, height}, kAll, 1);
    const test::NearestFilms films(frame, width);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec2 center(x + 0.5, y + 0.5);
            const test::NearestFilms::Nearest nearest = films.at(center);
            const double distance = field.distance.pixel(x, y)[0];
            ASSERT_NEAR(distance, nearest.distance, tolerance) << x << ", " << y;
            if (distance > kChainTolerance) {
                ASSERT_EQ(field.ids.pixel(x, y)[0], index_of(nearest.bubble)) << x << ", " << y;
                const Vec2 gradient = pair_at(field.gradient, x, y);
                ASSERT_NEAR(gradient.norm(), 1.0, 1e-6);
                ASSERT_LT(films.at(center - distance * gradient).distance, tolerance);
            }
        }
    }
}

TEST(Distance, IsThatOfTheNearestFilmOfAll) {
    expect_nearest(test::fitted_frame(test::bent_foam(30, 0.4, 21), 70, 70), 70, 70);
    expect_nearest(test::fitted_frame(test::bent_foam(8, 0.5, 4), 130, 61), 130, 61);
}

TEST(Distance, HoldsInManyBandsOfRows) {
    expect_nearest(test::fitted_frame(test::polydisperse_foam(40, 7), 140, 140), 140, 140);
}

TEST(Distance, HoldsForTinyAndLargeBubbles) {
    expect_nearest(test::fitted_frame(test::polydisperse_foam(60, 5), 64, 64), 64, 64);
    expect_nearest(test::fitted_frame(test::polydisperse_foam(60, 6), 9, 9), 9, 9);
    expect_nearest(test::fitted_frame(test::bent_foam(400, 0.3, 6), 20, 20), 20, 20);
}

TEST(Distance, HoldsForTwoSidedBubbles) {
    Foam foam = honeycomb(2, 2);
    test::insert_lens(foam, id_at<FilmId>(1), 0.6);
    test::insert_lens(foam, id_at<FilmId>(4), 0.25);
    expect_nearest(test::fitted_frame(foam, 60, 60), 60, 60);
}

// The bubble extends around the torus, so its neighbors are its own copies.
TEST(Distance, HoldsForABubbleThatMeetsItself) {
    expect_nearest(test::fitted_frame(test::single_bubble(), 50, 50), 50, 50);
    expect_nearest(test::fitted_frame(honeycomb(1, 2), 40, 40), 40, 40);
    expect_nearest(test::fitted_frame(test::single_bubble(), 1, 1), 1, 1);
}

// The shear between copies of a bubble is rounded to whole subpixels.
TEST(Distance, HoldsOnAShearedTorus) {
    Foam foam = test::bent_foam(16, 0.3, 8);
    shear(foam, 0.37);
    expect_nearest(test::fitted_frame(foam, 48, 48), 48, 48, 0.6 / kSubpixel);
}

void expect_shifted(const DistanceField& shifted, const DistanceField& field, int dx, int dy) {
    const int width = field.ids.width();
    const int height = field.ids.height();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int from_x = (x + dx) % width;
            const int from_y = (y + dy) % height;
            ASSERT_EQ(shifted.ids.pixel(x, y)[0], field.ids.pixel(from_x, from_y)[0]);
            ASSERT_EQ(shifted.distance.pixel(x, y)[0], field.distance.pixel(from_x, from_y)[0]);
            ASSERT_EQ(shifted.smooth.pixel(x, y)[0], field.smooth.pixel(from_x, from_y)[0]);
            ASSERT_EQ(pair_at(shifted.gradient, x, y), pair_at(field.gradient, from_x, from_y));
            ASSERT_EQ(pair_at(shifted.smooth_gradient, x, y),
                      pair_at(field.smooth_gradient, from_x, from_y));
        }
    }
}

TEST(Distance, ShiftsBitForBit) {
    for (const Foam& foam :
         {test::bent_foam(30, 0.4, 3), test::single_bubble(), test::bent_foam(600, 0.3, 5)}) {
        const Frame frame = test::fitted_frame(foam, 150, 280);
        const DistanceField field = distance_field(frame, {150, 280}, kAll, 1);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {74, 139}, {33, 70}}) {
            expect_shifted(distance_field(frame, {150, 280, dx, dy}, kAll, 1), field, dx, dy);
        }
    }
}

// Some bubbles are within a band of rows, some are in two bands, and some extend across the border.
TEST(Distance, ShiftsSmallBubblesBitForBit) {
    Foam foam = test::bent_foam(900, 0.3, 3);
    shear(foam, 0.21);
    const Frame frame = test::fitted_frame(foam, 110, 300);
    const DistanceField field = distance_field(frame, {110, 300}, kAll, 1);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {0, 64}, {109, 299}, {33, 150}}) {
        const RasterGrid grid{110, 300, dx, dy};
        const DistanceField shifted = distance_field(frame, grid, kAll, 2);
        const int rows = 300 - dy;  // rows beyond the border are displaced by the shear
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < 110; ++x) {
                const int from_x = (x + dx) % 110;
                ASSERT_EQ(shifted.ids.pixel(x, y)[0], field.ids.pixel(from_x, y + dy)[0]);
                ASSERT_EQ(shifted.distance.pixel(x, y)[0], field.distance.pixel(from_x, y + dy)[0]);
            }
        }
    }
}

void expect_equal(const DistanceField& a, const DistanceField& b) {
    EXPECT_EQ(a.ids, b.ids);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.gradient, b.gradient);
    EXPECT_EQ(a.smooth, b.smooth);
    EXPECT_EQ(a.smooth_gradient, b.smooth_gradient);
}

TEST(Distance, IsTheSameForAnyThreadsAndInUsedMemory) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(80, 9), 300, 300);
    const DistanceField one = distance_field(frame, {300, 300}, kAll, 1);
    expect_equal(one, distance_field(frame, {300, 300}, kAll, 2));
    expect_equal(one, distance_field(frame, {300, 300}, kAll, 5));
    DistanceField used = distance_field(frame, {300, 300, 7, 5}, kAll, 1);
    const float* memory = used.distance.samples().data();
    write_distance_field(frame, RasterGrid{300, 300}, kAll, 1, used);
    expect_equal(one, used);
    EXPECT_EQ(used.distance.samples().data(), memory);
    write_distance_field(frame, RasterGrid{300, 300}, {}, 1, used);
    EXPECT_EQ(used.distance, one.distance);
    EXPECT_TRUE(used.gradient.samples().empty());
    EXPECT_TRUE(used.smooth.samples().empty());
    EXPECT_TRUE(used.smooth_gradient.samples().empty());
}

TEST(Distance, SmoothDistancesWithoutGradientsAreTheSame) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(80, 9), 300, 300);
    const DistanceField all = distance_field(frame, {300, 300}, kAll, 1);
    const DistanceField some =
        distance_field(frame, {300, 300}, {.smooth = SmoothImages::Distance}, 1);
    EXPECT_EQ(some.ids, all.ids);
    EXPECT_EQ(some.distance, all.distance);
    EXPECT_EQ(some.smooth, all.smooth);
    EXPECT_TRUE(some.smooth_gradient.samples().empty());
}

// Without distances, smooth distances are the same.
TEST(Distance, IdsAndSmoothDistancesDoNotDependOnDistances) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(80, 9), 300, 300);
    const DistanceField all = distance_field(frame, {300, 300}, kAll, 1);
    DistanceNeeds needs = kAll;
    needs.distance = needs.gradient = false;
    const DistanceField smooth = distance_field(frame, {300, 300}, needs, 1);
    EXPECT_EQ(smooth.ids, all.ids);
    EXPECT_TRUE(smooth.distance.samples().empty());
    EXPECT_EQ(smooth.smooth, all.smooth);
    EXPECT_EQ(smooth.smooth_gradient, all.smooth_gradient);
    const DistanceField ids = distance_field(frame, {300, 300}, {.distance = false}, 1);
    EXPECT_EQ(ids.ids, all.ids);
    EXPECT_TRUE(ids.distance.samples().empty());
    EXPECT_TRUE(ids.smooth.samples().empty());
}

TEST(Distance, RejectsAnImageOfAnotherAspect) {
    const Frame frame = test::fitted_frame(honeycomb(2, 2), 8, 8);
    EXPECT_THROW(distance_field(frame, {9, 8}, {}, 1), std::invalid_argument);
}

// The memory of a field for the rejected grid might not be available.
TEST(Distance, ARejectedGridLeavesTheFieldUnchanged) {
    const Frame frame = test::fitted_frame(honeycomb(2, 2), 8, 8);
    const DistanceField field = distance_field(frame, {8, 8}, kAll, 1);
    DistanceField used = field;
    for (const RasterGrid& grid : {RasterGrid{9, 8}, {kMaxGridSide + 1, 1}}) {
        EXPECT_THROW(write_distance_field(frame, grid, {}, 1, used), std::invalid_argument);
        expect_equal(used, field);
    }
}

// At films the smooth distance agrees with the distance. Inside a bubble its gradient changes
// gradually, whereas the gradient of the distance jumps in the middle of the bubble.
TEST(SmoothDistance, HasNoCreases) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(12, 4), 160, 160);
    const DistanceField field = distance_field(frame, {160, 160}, kAll, 1);
    double largest_jump = 0.0;
    double largest_plain_jump = 0.0;
    for (int y = 0; y < 160; ++y) {
        for (int x = 0; x + 1 < 160; ++x) {
            const double smooth = field.smooth.pixel(x, y)[0];
            const double distance = field.distance.pixel(x, y)[0];
            ASSERT_GE(smooth, 0.0);
            ASSERT_LE(smooth, distance * 1.25 + 1e-6);
            const bool inside = field.ids.pixel(x, y)[0] == field.ids.pixel(x + 1, y)[0] &&
                                std::min(distance, double{field.distance.pixel(x + 1, y)[0]}) > 6.0;
            const auto jump = [&](const Image<float>& image) {
                return inside ? (pair_at(image, x + 1, y) - pair_at(image, x, y)).norm() : 0.0;
            };
            largest_jump = std::max(largest_jump, jump(field.smooth_gradient));
            largest_plain_jump = std::max(largest_plain_jump, jump(field.gradient));
        }
    }
    EXPECT_GT(largest_plain_jump, 1.4);
    EXPECT_LT(largest_jump, 0.3);
}

}  // namespace
}  // namespace foam::texgen
