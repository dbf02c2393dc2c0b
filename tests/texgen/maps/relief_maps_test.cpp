// Maps of distances and of the relief: values in closed form, in a lone bubble.
#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/curvature.h"
#include "texgen/maps/distance.h"
#include "texgen/maps/height.h"
#include "texgen/maps/id.h"
#include "texgen/maps/normal.h"
#include "texgen/maps/occlusion.h"
#include "texgen/maps/sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr int kSize = 64;
constexpr double kRadius = 25.0;  // pixels
constexpr double kDegree = std::numbers::pi / 180.0;

// A lone bubble of radius 1 in the middle of the image; its diameter is that of the mean bubble.
struct Circle {
    Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    FoamRecord record;
    FrameLayers layers{{frame, record, nullptr, {.gradient = true, .smooth = true}},
                       {kSize, kSize, 0, 0, View{Vec2::Zero(), kRadius}},
                       1};
};

// From the centre.
Vec2 place_of(int x, int y) {
    return Vec2(x + 0.5 - 0.5 * kSize, y + 0.5 - 0.5 * kSize);
}

// Calls visit(x, y, place) for pixels well within the circle.
template <class Visit>
void for_each_inside(const Visit& visit) {
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            if (place_of(x, y).norm() < kRadius - 1.0) {
                visit(x, y, place_of(x, y));
            }
        }
    }
}

// A cap of a sphere that meets the ground at an angle, at r from its axis.
struct Cap {
    double angle = 50.0 * kDegree;
    double sphere = kRadius / std::sin(angle);

    double height(double r) const {
        return std::sqrt(sphere * sphere - r * r) - sphere * std::cos(angle);
    }
};

TEST(ReliefMaps, DistanceIsToTheCircle) {
    Circle circle;
    const auto in_pixels =
        draw_distance(circle.layers, {.unit = DistanceUnit::Pixels}, AlbedoOptions{});
    const auto in_units = draw_distance(circle.layers, {}, AlbedoOptions{});
    for_each_inside([&](int x, int y, const Vec2& place) {
        const double expected = kRadius - place.norm();
        EXPECT_NEAR(in_pixels.pixels.pixel(x, y)[0], expected, 1e-4);
        EXPECT_NEAR(in_units.pixels.pixel(x, y)[0], expected / kRadius, 1e-5);
    });
    EXPECT_EQ(in_pixels.pixels.pixel(0, 0)[0], 0.0F);
}

// From the edge of a film of 3 pixels, and negative around the patch.
TEST(ReliefMaps, SignedDistanceIsFromTheEdge) {
    Circle circle;
    AlbedoOptions films;
    films.film_width = 3.0;
    const auto image = draw_distance(
        circle.layers, {.kind = DistanceKind::Signed, .unit = DistanceUnit::Pixels}, films);
    for (const int x : {0, 5, 20, 32}) {
        const double expected = kRadius - place_of(x, 32).norm() - 1.5;
        EXPECT_NEAR(image.pixels.pixel(x, 32)[0], expected, 1e-4) << x;
    }
    EXPECT_EQ(image.low, -image.high);
}

TEST(ReliefMaps, ALoneBubblesDomeIsACap) {
    Circle circle;
    const Cap cap;
    const auto height = draw_height(circle.layers, {}, {});
    const auto normal = draw_normal(circle.layers, {}, {});
    for_each_inside([&](int x, int y, const Vec2& place) {
        EXPECT_NEAR(height.pixels.pixel(x, y)[0], cap.height(place.norm()) / (2 * kRadius), 1e-4);
        const auto n = normal.pixels.pixel(x, y);
        EXPECT_NEAR(n[0], place.x() / cap.sphere, 1e-3);
        EXPECT_NEAR(n[1], place.y() / cap.sphere, 1e-3);
        EXPECT_NEAR(n[2], std::sqrt(1.0 - place.squaredNorm() / (cap.sphere * cap.sphere)), 1e-3);
    });
    EXPECT_EQ(height.pixels.pixel(0, 0)[0], 0.0F);
    EXPECT_EQ(normal.pixels.pixel(0, 0)[2], 1.0F);
}

TEST(ReliefMaps, DirectXNormalsPointDown) {
    FrameInput input = test::torus_subject().input();
    input.distance = {.gradient = true, .smooth = true};
    FrameLayers layers(input, test::torus_grid(64), 1);
    const auto up = draw_normal(layers, {}, {.y = NormalY::Up});
    const auto down = draw_normal(layers, {}, {.y = NormalY::Down});
    for (std::size_t k = 0; k < up.pixels.samples().size(); ++k) {
        const float sign = k % 3 == 1 ? -1.0F : 1.0F;
        ASSERT_EQ(up.pixels.samples()[k], sign * down.pixels.samples()[k]);
    }
}

// Both fall to their foot; a ridge is half as high as wide. A fillet has 1 - sqrt(0.19) at a tenth
// of its radius and a slope of -0.9 / sqrt(0.19), which the crest of the film takes on evenly.
TEST(ReliefMaps, RidgesAndBordersStandOnFilms) {
    const ReliefSection ridge(ReliefProfile::Ridge, 1.0);
    EXPECT_EQ(ridge.height(0.0), 0.5);
    EXPECT_EQ(ridge.slope(0.0), 0.0);
    EXPECT_EQ(ridge.height(1.0), 0.0);
    EXPECT_NEAR(ridge.height(0.5), 0.5 * 0.75 * 0.75, 1e-15);
    const ReliefSection wet(ReliefProfile::Wet, 1.0);
    const double root = std::sqrt(0.19);
    EXPECT_NEAR(wet.height(0.1), 1.0 - root, 1e-15);
    EXPECT_NEAR(wet.slope(0.1), -0.9 / root, 1e-15);
    EXPECT_NEAR(wet.height(0.0), 1.0 - root + 0.05 * 0.9 / root, 1e-15);
    EXPECT_EQ(wet.slope(0.0), 0.0);
    EXPECT_NEAR(wet.height(1.0), 0.0, 1e-15);
    EXPECT_EQ(wet.slope(1.5), 0.0);
}

TEST(ReliefMaps, SlopesAreDerivativesOfHeights) {
    constexpr double kStep = 1e-5;
    for (const auto profile : {ReliefProfile::Dome, ReliefProfile::Ridge, ReliefProfile::Wet}) {
        const ReliefSection section(profile, 0.9);
        for (const double s : {0.05, 0.07, 0.2, 0.45, 0.7, 0.95, 1.3}) {
            const double difference =
                (section.height(s + kStep) - section.height(s - kStep)) / (2.0 * kStep);
            EXPECT_NEAR(section.slope(s), difference, 1e-7) << s;
            if (s < 0.5) {
                EXPECT_NEAR(section.smooth(section.way(s)), s, 1e-12);
            }
        }
    }
}

// A bubble may be smaller than what curvature is felt over: past a dome's middle comes its other
// film, and past that the next dome.
TEST(ReliefMaps, ADomeGoesOnInBothDirections) {
    const ReliefSection dome(ReliefProfile::Dome, 0.9);
    for (const double x : {0.0, 0.3, 0.9}) {
        for (const double far : {-x, 2.0 - x, 2.0 + x, 8.0 - x, -40.0 - x}) {
            EXPECT_NEAR(dome.height_along(far), dome.height_along(x), 1e-14) << far;
        }
    }
    EXPECT_GT(dome.height_along(1.0), dome.height_along(0.9));
}

// At the foot of a furrow whose walls rise by 30 degrees a wall sees the sky from its own plane to
// 60 degrees from its normal on the other side ... the normal leans 30 degrees to the other wall,
// which ends 60 degrees from upright: (sin 90 + sin 30) / 2. In the middle of a cap nothing is
// above.
TEST(ReliefMaps, OcclusionIsThatOfAFurrow) {
    Circle circle;
    const auto image = draw_occlusion(circle.layers, {.angle = 30.0}, {});
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0], 1.0, 1e-3);
    float least = 1.0F;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            least = std::min(least, image.pixels.pixel(x, y)[0]);
        }
    }
    EXPECT_NEAR(least, 0.75, 0.01);  // somewhere near the rim
    EXPECT_EQ(image.pixels.pixel(0, 0)[0], 1.0F);
    const auto squared = draw_occlusion(circle.layers, {.angle = 30.0}, {.strength = 2.0});
    EXPECT_NEAR(
        squared.pixels.pixel(20, 40)[0], std::pow(image.pixels.pixel(20, 40)[0], 2.0), 1e-6);
}

// A cap bends alike everywhere, up to the second order of the radius.
TEST(ReliefMaps, CurvatureOfACapIsThatOfItsSphere) {
    Circle circle;
    const auto image = draw_curvature(circle.layers, {}, {.radius = 0.01});
    const Cap cap;
    const double expected = 2.0 * kRadius / cap.sphere;
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0], expected, 0.02 * expected);
    float at_rim = 0.0F;
    const auto wide = draw_curvature(circle.layers, {}, {.radius = 0.1});
    for_each_inside(
        [&](int x, int y, const Vec2&) { at_rim = std::min(at_rim, wide.pixels.pixel(x, y)[0]); });
    EXPECT_LT(at_rim, -3.0F);  // a furrow
    EXPECT_EQ(image.pixels.pixel(0, 0)[0], 0.0F);
}

TEST(ReliefMaps, IdsAndSidesAreExact) {
    Circle circle;
    const IdPixels id = draw_id(circle.layers);
    const IdPixels sides = draw_sides(circle.layers);
    for (int x = 0; x < kSize; ++x) {
        const bool inside = place_of(x, 32).norm() < kRadius;
        EXPECT_EQ(id.pixels.pixel(x, 32)[0], inside ? 8U : 0U);
        EXPECT_EQ(sides.pixels.pixel(x, 32)[0], 0U);
    }
    const Frame frame = foam::test::fitted_frame(honeycomb(4, 4), kSize, kSize);
    FrameLayers layers({frame, circle.record}, {kSize, kSize}, 1);
    std::array<int, 17> pixels{};
    const IdPixels ids = draw_id(layers);
    for (const std::uint32_t one : ids.pixels.samples()) {
        ++pixels.at(one);
    }
    EXPECT_EQ(pixels[0], 0);
    for (std::size_t k = 1; k < pixels.size(); ++k) {
        EXPECT_NEAR(pixels[k], kSize * kSize / 16, 12);
    }
    const IdPixels hexagons = draw_sides(layers);
    for (const std::uint32_t one : hexagons.pixels.samples()) {
        ASSERT_EQ(one, 6U);
    }
}

}  // namespace
}  // namespace foam::texgen
