// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pressure.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/image/colormap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

// A torus of 2 x 2 hexagons, whose pressures are set by the tests.
struct Hexagons {
    Frame frame = foam::test::fitted_frame(honeycomb(2, 2), 64, 64);
    FoamRecord record;

    std::vector<float> tones(const PressureOptions& options) {
        FrameLayers layers({frame, record}, {64, 64}, 1);
        const MapImage image = draw_pressure(layers, options);
        const auto samples = std::get<NumberPixels>(image).pixels.samples();
        std::vector<float> found(samples.begin(), samples.end());
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    void set_pressures(const std::array<double, 4>& pressures) {
        for (std::size_t k = 0; k < 4; ++k) {
            frame.bubbles[id_at<BubbleId>(k)].pressure = frame.film_tension * pressures[k];
        }
    }
};

TEST(Pressure, ARangeOfPressuresIsMeasured) {
    Hexagons hexagons;
    hexagons.set_pressures({-0.5, 0.0, 0.5, 1.5});
    PressureOptions options;
    options.scaling = PressureScaling::Range;
    options.unit = PressureUnit::Seed;
    options.low = -0.5;
    options.high = 1.5;
    const std::vector<float> tones = hexagons.tones(options);
    // Films have no width. Pixels that several bubbles share have tones between those of the
    // bubbles.
    EXPECT_EQ(tones.front(), 0.0F);
    EXPECT_EQ(tones.back(), 1.0F);
    EXPECT_TRUE(std::any_of(
        tones.begin(), tones.end(), [](float tone) { return std::abs(tone - 0.25F) < 1e-5F; }));
    options.exaggeration = 3.0;  // 0.5 + 3 (t - 0.5), not clamped
    EXPECT_EQ(hexagons.tones(options).front(), -1.0F);
    EXPECT_EQ(hexagons.tones(options).back(), 2.0F);
}

// The pressures of the first frame are 0, 1, ..., 100. Without the lowest and the highest 10 %,
// they are from 10 to 90. The ranks of 0 and 25 are 0 and 1/4; ranks are interpolated between two
// pressures.
TEST(Pressure, TonesAreThoseOfTheFirstFrame) {
    Hexagons hexagons;
    for (int k = 0; k <= 100; ++k) {
        hexagons.record.first_pressures.push_back(k);
    }
    hexagons.frame.film_tension = std::sqrt(hexagons.frame.domain.area() / 4.0);
    for (FrameBubble& bubble : hexagons.frame.bubbles) {
        bubble.pressure = 50.0;
    }
    hexagons.frame.bubbles[id_at<BubbleId>(0)].pressure = 25.5;
    hexagons.frame.bubbles[id_at<BubbleId>(1)].pressure = 98.0;
    PressureOptions options;
    options.percentile = 10.0;
    EXPECT_NEAR(hexagons.tones(options).front(), 15.5 / 80.0, 1e-5);
    EXPECT_NEAR(hexagons.tones(options).back(), 1.1, 1e-5);
    options.scaling = PressureScaling::Rank;
    EXPECT_NEAR(hexagons.tones(options).front(), 0.255, 1e-5);
    EXPECT_NEAR(hexagons.tones(options).back(), 0.98, 1e-5);
}

TEST(Pressure, WithoutAScaleTonesAreInTheMiddle) {
    Hexagons hexagons;
    for (const auto scaling : {PressureScaling::Percentile, PressureScaling::Rank}) {
        PressureOptions options;
        options.scaling = scaling;
        EXPECT_EQ(hexagons.tones(options), std::vector<float>{0.5F});
    }
}

TEST(Pressure, AnEmptyRangeIsRejected) {
    Hexagons hexagons;
    PressureOptions options;
    options.low = 0.5;
    options.high = 0.25;
    try {
        hexagons.tones(options);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()),
                  "pressure.low is 0.5, but must be below pressure.high, which is 0.25");
    }
}

// A share of bubbles has a share of ranks, whatever their pressures are.
TEST(Pressure, RanksSpreadTonesEvenly) {
    test::MapSubject subject = test::torus_subject();
    FrameLayers layers(subject.input(), test::torus_grid(16), 1);
    PressureOptions options;
    options.scaling = PressureScaling::Rank;
    const auto& pressures = subject.record.first_pressures;
    ASSERT_EQ(pressures.size(), 24U);
    const MapImage image = draw_pressure(layers, options);
    for (const float tone : std::get<NumberPixels>(image).pixels.samples()) {
        EXPECT_GE(tone, 0.0F);
        EXPECT_LE(tone, 1.0F);
    }
}

// Returns the tones of a foam of very different areas, one per pixel.
std::vector<float> torus_tones(const PressureOptions& options) {
    FrameLayers layers(test::torus_subject().input(), test::torus_grid(64), 1);
    const MapImage image = draw_pressure(layers, options);
    const auto samples = std::get<NumberPixels>(image).pixels.samples();
    return {samples.begin(), samples.end()};
}

// The mean of tones that are spread evenly over the area is 1/2, whatever the pressures are.
TEST(Pressure, SharesSpreadTonesEvenlyOverTheArea) {
    PressureOptions options;
    options.scaling = PressureScaling::Share;
    const std::vector<float> tones = torus_tones(options);
    const double sum = std::accumulate(tones.begin(), tones.end(), 0.0);
    EXPECT_NEAR(sum / static_cast<double>(tones.size()), 0.5, 1e-4);
    EXPECT_GT(*std::min_element(tones.begin(), tones.end()), 0.0F);
    EXPECT_LT(*std::max_element(tones.begin(), tones.end()), 1.0F);
}

TEST(Pressure, BubblesOfEqualPressureHaveTheMiddleShare) {
    Hexagons hexagons;
    PressureOptions options;
    options.scaling = PressureScaling::Share;
    EXPECT_EQ(hexagons.tones(options), std::vector<float>{0.5F});
}

// Returns the sum of the differences between adjacent pixels of a row.
double roughness_of(const std::vector<float>& tones) {
    double sum = 0.0;
    for (std::size_t k = 1; k < tones.size(); ++k) {
        sum += static_cast<double>(k % 64 == 0 ? 0.0F : std::abs(tones[k] - tones[k - 1]));
    }
    return sum;
}

TEST(Pressure, SmoothingBringsNeighborsTogetherAndFlatteningRemovesWideDifferences) {
    PressureOptions options;
    options.scaling = PressureScaling::Range;
    const double plain = roughness_of(torus_tones(options));
    options.smoothing = 3;
    const double smooth = roughness_of(torus_tones(options));
    EXPECT_LT(smooth, 0.5 * plain);
    // After very many rounds of the wider average only its mean is left, which is subtracted.
    options.smoothing = 0;
    options.flattening = 1000;
    const std::vector<float> flat = torus_tones(options);
    EXPECT_NEAR(roughness_of(flat), plain, 0.01 * plain);
    options.flattening = 1;
    EXPECT_LT(roughness_of(torus_tones(options)), plain);
}

TEST(Pressure, LimitsHoldOnBothSides) {
    test::expect_limits(pressure_keys(),
                        {{"percentile", "-1", "0", "49", "50"},
                         {"exaggeration", "-1", "0", "1000", "1001"},
                         {"smoothing", "-1", "0", "1000", "1001"},
                         {"flattening", "-1", "0", "1000", "1001"},
                         {"low", "-1e7", "-1e6", "1e6", "1e7"},
                         {"high", "-1e7", "-1e6", "1e6", "1e7"}});
}

TEST(Pressure, ChoicesHaveTheirWords) {
    test::expect_words(pressure_keys(), "scaling", {"range", "percentile", "rank", "share"});
    test::expect_words(pressure_keys(), "unit", {"seed", "current"});
    std::vector<std::string> colormaps(colormap_names().begin(), colormap_names().end());
    colormaps.emplace_back("none");
    test::expect_words(pressure_keys(), "colormap", colormaps);
}

}  // namespace
}  // namespace foam::texgen
