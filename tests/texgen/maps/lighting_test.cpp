// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lighting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

// Returns the diffuse light and the shine at one point.
std::pair<double, double> light_at(const LightOptions& options, double x, double y, double sky) {
    const std::vector<float> slopes_x = {static_cast<float>(x)};
    const std::vector<float> slopes_y = {static_cast<float>(y)};
    const std::vector<float> skies = {static_cast<float>(sky)};
    std::vector<float> diffuse(1);
    std::vector<float> shine(1);
    Lighting(options).shade({slopes_x, slopes_y, skies}, {diffuse, shine});
    return {static_cast<double>(diffuse[0]), static_cast<double>(shine[0])};
}

TEST(Lighting, FlatGroundUnderTheWholeSkyKeepsItsColor) {
    const LightOptions options{
        .gloss = 2.0, .rim = 1.0, .reflections = {.windows = 2, .horizon = 1.0}};
    const auto [diffuse, shine] = light_at(options, 0.0, 0.0, 1.0);
    EXPECT_FLOAT_EQ(static_cast<float>(diffuse), 1.0F);
    EXPECT_EQ(shine, 0.0);
}

// Lambert's law: a slope of 30 degrees toward a light from the right, at an elevation of 50
// degrees, is at 10 degrees from the light. Flat ground is at 40 degrees from it.
TEST(Lighting, DirectLightFollowsTheCosine) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const LightOptions options{.azimuth = 0.0, .elevation = 50.0, .ambient = 0.0, .gloss = 0.0};
    const double slope = -std::tan(30.0 * kDegree);
    EXPECT_NEAR(light_at(options, slope, 0.0, 1.0).first,
                std::cos(10.0 * kDegree) / std::cos(40.0 * kDegree),
                1e-6);
    EXPECT_EQ(light_at(options, std::tan(60.0 * kDegree), 0.0, 1.0).first, 0.0);
}

TEST(Lighting, AmbientLightComesFromTheVisibleSky) {
    const LightOptions options{.ambient = 1.0, .gloss = 0.0};
    EXPECT_NEAR(light_at(options, 0.7, -0.2, 0.3).first, 0.3, 1e-6);
}

// The highlight is the power of the cosine of the angle between the normal and the halfway vector,
// minus its value on flat ground. Exponents of 1 to 10,000 use the same table.
TEST(Lighting, HighlightsAreThoseOfBlinn) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    for (const double shininess : {1.0, 40.0, 10000.0}) {
        const LightOptions options{.azimuth = 0.0,
                                   .elevation = 50.0,
                                   .ambient = 0.0,
                                   .gloss = 1.0,
                                   .shininess = shininess};
        for (const double tilt : {0.0, 5.0, 15.0, 19.0, 19.9, 20.0, 20.5, 25.0, 60.0}) {
            const double expected = std::pow(std::cos((tilt - 20.0) * kDegree), shininess) -
                                    std::pow(std::cos(20.0 * kDegree), shininess);
            EXPECT_NEAR(light_at(options, -std::tan(tilt * kDegree), 0.0, 1.0).second,
                        std::max(expected, 0.0),
                        2e-5)
                << shininess << ' ' << tilt;
        }
    }
}

TEST(Lighting, TheRimIsBrightOnSteepSlopes) {
    const LightOptions options{.ambient = 0.0, .gloss = 0.0, .rim = 2.0};
    const double steep = 1.0 - 1.0 / std::sqrt(1.0 + 4.0);
    EXPECT_NEAR(light_at(options, 0.0, 2.0, 1.0).second, 2.0 * std::pow(steep, 3), 1e-6);
}

}  // namespace
}  // namespace foam::texgen
