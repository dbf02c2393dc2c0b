// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/caustics.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

// Returns the light on the floor at every pixel. With the colors black and white, the sRGB value of
// a pixel is 1 - exp(-exposure * light).
std::vector<double> light_of(const Frame& frame, const RasterGrid& grid, MapOptions options) {
    options.caustics.colors = {"#000000", "#ffffff"};
    const FoamRecord record;
    FrameLayers layers({frame, record}, grid, 1);
    const Image<std::uint16_t> image =
        draw_caustics(layers, {options.relief, options.maze}, options.caustics).pixels;
    std::vector<double> light;
    const auto channels = static_cast<std::size_t>(image.channels());
    for (std::size_t k = 0; k < image.samples().size(); k += channels) {
        const double brightness = linear_to_srgb(image.samples()[k] / kWhite);
        light.push_back(-std::log(1.0 - brightness) / options.caustics.exposure);
    }
    return light;
}

double mean(const std::vector<double>& numbers) {
    double sum = 0.0;
    for (const double number : numbers) {
        sum += number;
    }
    return sum / static_cast<double>(numbers.size());
}

TEST(Caustics, FlatWaterLightsTheFloorEvenly) {
    MapOptions options;
    options.relief.strength = 0.0;
    for (const int samples : {1, 3, 8}) {
        options.caustics.samples = samples;
        for (const double light :
             light_of(test::torus_subject().frame, test::torus_grid(kSize), options)) {
            EXPECT_NEAR(light, 1.0, 1e-3);
        }
    }
}

// The water moves light but loses none of it. A low exposure resolves the brightest pixels.
TEST(Caustics, NoLightIsLostOnATorus) {
    for (const ReliefProfile profile : {ReliefProfile::Dome, ReliefProfile::Ridge}) {
        MapOptions options;
        options.relief.profile = profile;
        options.relief.width = 0.5;
        options.caustics.depth = 0.8;
        options.caustics.exposure = 0.2;
        const std::vector<double> light =
            light_of(test::torus_subject().frame, test::torus_grid(kSize), options);
        EXPECT_NEAR(mean(light), 1.0, 2e-3);
    }
}

// A spherical dome is a lens. A ray at a distance x from its axis meets the slope x / r, where r is
// the radius of the sphere (for gentle slopes), and moves toward the axis by
// depth * (1 - 1/1.33) * x / r. All lengths are divided by 1 minus this factor, so the light in the
// middle is divided by its square.
TEST(Caustics, ADomeGathersLightInItsMiddle) {
    constexpr double kRadius = 40.0;  // of the bubble, pixels
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    MapOptions options;
    options.relief.angle = 10.0;
    options.relief.mean_bubble = MeanBubble::Current;  // a diameter of 2 * kRadius
    options.caustics.depth = 5.0;
    options.caustics.exposure = 0.1;
    options.caustics.samples = 8;
    const std::vector<double> light =
        light_of(frame, {kSize, kSize, 0, 0, View{Vec2::Zero(), kRadius}}, options);
    const double sphere = kRadius / std::sin(10.0 * std::numbers::pi / 180.0);
    const double scale = 1.0 - 5.0 * 2.0 * kRadius * (1.0 - 1.0 / 1.33) / sphere;
    const double middle = light[kSize * kSize / 2 + kSize / 2];
    EXPECT_NEAR(middle, 1.0 / (scale * scale), 0.02 / (scale * scale));
}

TEST(Caustics, LimitsHoldOnBothSides) {
    test::expect_limits(caustics_keys(),
                        {{"depth", "-0.1", "0", "100", "101"},
                         {"exposure", "-0.1", "0", "100", "101"},
                         {"samples", "0", "1", "8", "9"}});
}

}  // namespace
}  // namespace foam::texgen
