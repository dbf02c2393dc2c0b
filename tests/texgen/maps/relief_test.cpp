// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/spherical_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace foam::texgen {
namespace {

const ReliefOptions kRelief;
const MazeOptions kMaze;

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

Vec2 slope_at(const PixelSlopes& slopes, std::size_t index) {
    return {slopes.x.samples()[index], slopes.y.samples()[index]};
}

// The dome of a lone bubble with a radius of R pixels is a cap of a sphere of radius S = R / sin(50
// degrees). The slope at r is -r / sqrt(S² - r²).
TEST(Relief, SlopesAndHeightsAreThoseOfACap) {
    LoneCircle circle(kRadius);
    const Relief relief(circle.layers, {kRelief, kMaze}, Relief::kFoot);
    const test::SphericalCap cap{kRadius};
    EXPECT_NEAR(relief.diameter(), 2.0 * kRadius, 1e-9);
    const Image<float> heights = relief.heights();
    const PixelSlopes slopes = relief.slopes();
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2& point) {
        const auto index = static_cast<std::size_t>(y * test::kCircleImage + x);
        const double r = point.norm();
        EXPECT_NEAR(heights.samples()[index], cap.height(r), 5e-3);
        EXPECT_NEAR(
            slope_at(slopes, index).norm(), r / std::sqrt(cap.sphere * cap.sphere - r * r), 5e-3);
    });
}

// The slope of a relief with grain is the derivative of its height, also in the ring where the
// grain fades toward the film. A difference of heights at neighboring pixels reduces the slope of
// the finest octave, whose features are 3 pixels wide, by about a fifth, and those of the four
// others by less: by about 1 % of the squares in all.
class ReliefOfEveryProfile : public testing::TestWithParam<ReliefProfile> {};

INSTANTIATE_TEST_SUITE_P(Profiles,
                         ReliefOfEveryProfile,
                         testing::Values(ReliefProfile::Dome,
                                         ReliefProfile::Ridge,
                                         ReliefProfile::Wet));

TEST_P(ReliefOfEveryProfile, SlopesOfGrainAreThoseOfItsHeights) {
    LoneCircle circle(kRadius);
    const ReliefOptions plain{.profile = GetParam()};
    const ReliefOptions grained{.profile = GetParam(), .grain = 0.1, .grain_size = 1.0};
    const Relief with(circle.layers, {grained, kMaze}, Relief::kFoot);
    const Relief without(circle.layers, {plain, kMaze}, Relief::kFoot);
    const std::array heights = {with.heights(), without.heights()};
    const std::array slopes = {with.slopes(), without.slopes()};
    double errors = 0.0;
    double squares = 0.0;
    test::for_each_inside(kRadius - 2.0, [&](int x, int y, const Vec2& point) {
        if (point.norm() < kRadius - 6.0) {
            return;
        }
        const auto index = static_cast<std::size_t>(y * test::kCircleImage + x);
        const auto height = [&](std::size_t k) {
            return static_cast<double>(heights[0].samples()[k] - heights[1].samples()[k]);
        };
        const auto rise = [&](std::size_t step) {
            return 0.5 * (height(index + step) - height(index - step));
        };
        const Vec2 slope = slope_at(slopes[0], index) - slope_at(slopes[1], index);
        errors += (slope - Vec2(rise(1), rise(test::kCircleImage))).squaredNorm();
        squares += slope.squaredNorm();
    });
    EXPECT_LT(errors, 0.05 * squares);
    EXPECT_GT(squares, 1.0);
}

// On flat ground, the deepest hollow of a grain is not below the ground. Around the patch there is
// no grain.
TEST(Relief, GrainOnFlatGroundOnlyRises) {
    LoneCircle circle(kRadius);
    const ReliefOptions options{
        .profile = ReliefProfile::Ridge, .width = 0.01, .grain = 0.1, .grain_size = 0.3};
    const Relief relief(circle.layers, {options, kMaze}, Relief::kFoot);
    const Image<float> heights = relief.heights();
    EXPECT_GE(std::ranges::min(heights.samples()), 0.0F);
    const auto highest = static_cast<double>(std::ranges::max(heights.samples()));
    EXPECT_GT(highest, 0.2 * 2.0 * kRadius);
    EXPECT_LT(highest, 0.4 * 2.0 * kRadius);
    EXPECT_EQ(heights.samples()[0], 0.0F);
}

TEST(Relief, AroundAPatchADomeIsFlat) {
    LoneCircle circle(kRadius);
    const Relief relief(circle.layers, {kRelief, kMaze}, Relief::kFoot);
    EXPECT_EQ(relief.heights().samples()[0], 0.0F);
    EXPECT_EQ(slope_at(relief.slopes(), 0), Vec2(0.0, 0.0));
}

// The wall of a maze of one lone bubble is its circle. At the distance d from the wall, a ridge of
// width w has the height (1 - (d / w)²)² w / 2.
TEST(Relief, OfWallsRisesFromTheWalls) {
    LoneCircle circle(kRadius);
    constexpr double kWidth = 6.0;
    const ReliefOptions options{.profile = ReliefProfile::Ridge,
                                .films = ReliefFilms::Walls,
                                .width = kWidth / (2.0 * kRadius)};
    const Relief relief(circle.layers, {options, kMaze}, Relief::kFoot);
    const Image<float> heights = relief.heights();
    const PixelSlopes slopes = relief.slopes();
    for (int x = 0; x < test::kCircleImage; ++x) {
        const auto index = static_cast<std::size_t>(32 * test::kCircleImage + x);
        const Vec2 point = test::from_middle(x, 32);
        const double from_wall = point.norm() - kRadius;
        const double t = std::min(std::abs(from_wall) / kWidth, 1.0);
        EXPECT_NEAR(heights.samples()[index], 0.5 * kWidth * std::pow(1.0 - t * t, 2), 1e-5) << x;
        const double slope = -2.0 * t * (1.0 - t * t) * std::copysign(1.0, from_wall);
        EXPECT_NEAR(slope_at(slopes, index).dot(point.normalized()), slope, 1e-5) << x;
    }
}

// Films that are open leave the ground flat.
TEST(Relief, OfWallsIsFlatAtOpenFilms) {
    const Frame frame = foam::test::fitted_frame(foam::test::polydisperse_foam(40, 1), 256, 256);
    const FoamRecord record;
    const RasterGrid grid{256, 256};
    FrameLayers layers({frame, record}, grid, 1);
    const ReliefOptions options{.profile = ReliefProfile::Ridge,
                                .films = ReliefFilms::Walls,
                                .width = 0.05,
                                .mean_bubble = MeanBubble::Seed};
    const Relief relief(layers, {options, kMaze}, Relief::kFoot);
    const Maze graph = find_maze(frame, maze_rule(kMaze));
    const double scale = pixels_per_unit(grid, frame.domain);
    const Image<float> heights = relief.heights();
    int walls = 0;
    int open = 0;
    for (const FilmId film : frame.network.films()) {
        const FilmArc arc = frame.arc(forward_side(film));
        const Vec2 middle =
            scale * (frame.positions[frame.network.tail(forward_side(film))] + point_at(arc, 0.5));
        const auto wrapped = [](double at) {
            return static_cast<std::size_t>(static_cast<int>(std::floor(at)) & 255);
        };
        const std::size_t index = 256 * wrapped(middle.y()) + wrapped(middle.x());
        if (graph.is_open[film] == 0) {
            EXPECT_GT(heights.samples()[index], 0.8 * 0.5 * 0.05 * relief.diameter());
            ++walls;
        } else if (scale * arc.chord.norm() > 12.0) {
            EXPECT_EQ(heights.samples()[index], 0.0F);
            ++open;
        }
    }
    EXPECT_GT(walls, 40);
    EXPECT_GT(open, 20);
}

TEST(Relief, StrengthIsAFactor) {
    LoneCircle circle(kRadius);
    const Relief once(circle.layers, {kRelief, kMaze}, Relief::kFoot);
    const ReliefOptions strong{.strength = 3.0};
    const Relief thrice(circle.layers, {strong, kMaze}, Relief::kFoot);
    const std::size_t middle = 32 * test::kCircleImage + 40;
    EXPECT_FLOAT_EQ(thrice.heights().samples()[middle], 3.0F * once.heights().samples()[middle]);
}

}  // namespace
}  // namespace foam::texgen
