// Maps that have one value per bubble, and masks: values by hand.
#include "core/dynamics/step.h"
#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/image/color.h"
#include "texgen/maps/film.h"
#include "texgen/maps/id_color.h"
#include "texgen/maps/opacity.h"
#include "texgen/maps/sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

// A lone bubble of radius 1 in the middle of 64 pixels, 20 to the unit.
struct Circle {
    Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    FoamRecord record;
    FrameLayers layers{{frame, record}, {64, 64, 0, 0, View{Vec2::Zero(), 20.0}}, 1};
};

// Two pressures on a torus of 2 x 2 hexagons, read in the unit of the seeded foam.
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

double sum_of(const Image<float>& image) {
    double sum = 0.0;
    for (const float value : image.samples()) {
        sum += value;
    }
    return sum;
}

AlbedoOptions films_of(double pixels) {
    AlbedoOptions options;
    options.film_width = pixels;
    return options;
}

// A ring from 18.5 to 21.5 pixels: 120 pi; and the disc within its outer rim.
TEST(CellMaps, FilmAndOpacityHaveTheAreaOfARing) {
    Circle circle;
    const double pi = std::numbers::pi;
    const auto film = draw_film(circle.layers, films_of(3.0));
    EXPECT_NEAR(sum_of(film.pixels), 120.0 * pi, 0.05);
    const auto opacity = draw_opacity(circle.layers, films_of(3.0));
    EXPECT_NEAR(sum_of(opacity.pixels), 21.5 * 21.5 * pi, 0.1);
    EXPECT_EQ(opacity.pixels.pixel(32, 32)[0], 1.0F);
    EXPECT_EQ(opacity.pixels.pixel(0, 0)[0], 0.0F);
}

TEST(CellMaps, OpacityIsAlbedosAlpha) {
    FrameLayers layers(test::patch_subject().input(), test::patch_grid(96), 1);
    const ColorPixels albedo = draw_albedo(layers, films_of(2.0));
    const NumberPixels opacity = draw_opacity(layers, films_of(2.0));
    for (std::size_t k = 0; k < opacity.pixels.samples().size(); ++k) {
        ASSERT_EQ(opacity.pixels.samples()[k],
                  static_cast<float>(albedo.pixels.samples()[4 * k + 3] / 65535.0));
    }
}

// A disc of area pi, alone, is its own mean.
TEST(CellMaps, AreaIsInMeanAreas) {
    Circle circle;
    const auto at_middle = [&](const AreaOptions& options) {
        return draw_area(circle.layers, options).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle({.unit = MeanBubble::Seed}), std::numbers::pi, 1e-6);
    EXPECT_NEAR(at_middle({.unit = MeanBubble::Current}), 1.0, 1e-6);
    EXPECT_EQ(draw_area(circle.layers, {.full = 9.0}).high, 9.0);
}

TEST(CellMaps, AgeIsSinceBirthOrChange) {
    Circle circle;
    circle.frame.time = 10.0;
    circle.record.births.assign(8, 4.0);
    circle.record.changes.assign(8, 9.0);
    const auto at_middle = [&](const AgeOptions& options) {
        return draw_age(circle.layers, options).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle({}), 6.0, 1e-6);
    EXPECT_NEAR(at_middle({.since = AgeSince::Change}), 1.0, 1e-6);
    circle.record.changes[7] = 0.0;  // before it was born
    EXPECT_NEAR(at_middle({.since = AgeSince::Change}), 6.0, 1e-6);
}

// From pi to pi + 0.5 in a time of 2; then it is gone.
TEST(CellMaps, GrowthIsTheChangeOverTheTime) {
    const Circle circle;
    Frame next = snapshot(foam::test::circles({{7, {0.1, 0.0}, std::numbers::pi + 0.5}}), 2);
    next.time = 2.0;
    const auto at_middle = [&] {
        FrameLayers layers({circle.frame, circle.record, &next}, circle.layers.grid(), 1);
        return draw_growth(layers, {}).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle(), 0.25, 1e-6);
    next.lone_bubbles.clear();
    EXPECT_NEAR(at_middle(), -0.5 * std::numbers::pi, 1e-6);
    next.time = 0.0;
    EXPECT_EQ(at_middle(), 0.0F);
}

// Without T1 and T2 between two frames every area follows von Neumann's law (E6).
TEST(CellMaps, GrowthIsVonNeumannsLaw) {
    Foam foam = foam::test::polydisperse_foam(24, 5);
    const Frame frame = snapshot(foam, 1);
    foam.events.clear();
    step(foam, 1e-3, {});
    ASSERT_TRUE(foam.events.empty());
    const Frame next = snapshot(foam, 2);
    const FoamRecord record;
    FrameLayers layers({frame, record, &next}, {64, 64}, 1);
    const NumberPixels growth = draw_growth(layers, {});
    FrameLayers again({frame, record}, {64, 64}, 1);
    const IdPixels sides = draw_sides(again);
    const double rate = std::numbers::pi / 3.0 * frame.film_tension * CoarseningOptions{}.kappa;
    int checked = 0;
    for (int x = 2; x < 62; ++x) {
        const auto near = {sides.pixels.pixel(x - 2, 20)[0], sides.pixels.pixel(x + 2, 20)[0]};
        const std::uint32_t here = sides.pixels.pixel(x, 20)[0];
        if (std::all_of(near.begin(), near.end(), [&](std::uint32_t n) { return n == here; })) {
            EXPECT_NEAR(growth.pixels.pixel(x, 20)[0], rate * (double(here) - 6.0), 1e-4);
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

// A spot of radius 8 pixels in its third frame of 4: half as high; (1 - 1/4)² of it half way out.
TEST(CellMaps, ASpotFadesInTimeAndSpace) {
    Circle circle;
    circle.record.frame = 5;
    circle.record.events = {{TopologyEventKind::T2, 3, {0.025, 0.025}},
                            {TopologyEventKind::T1, 1, {0.025, 0.025}}};
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;
    const NumberPixels image =
        draw_event(circle.layers, {.radius = 8.0 / (20.0 * diameter), .fade = 4});
    EXPECT_EQ(image.pixels.pixel(32, 32)[1], 0.5F);
    EXPECT_NEAR(image.pixels.pixel(36, 32)[1], 0.5 * 0.5625, 1e-6);
    EXPECT_EQ(image.pixels.pixel(32, 41)[1], 0.0F);
    EXPECT_EQ(image.pixels.pixel(32, 32)[0], 0.0F);  // over
    EXPECT_EQ(image.pixels.pixel(32, 32)[2], 0.0F);
}

TEST(CellMaps, RoughnessIsThatOfCellsAndFilms) {
    Circle circle;
    const auto at = [&](int x, const RoughnessOptions& options) {
        return draw_roughness(circle.layers, options, films_of(4.0)).pixels.pixel(x, 32)[0];
    };
    EXPECT_NEAR(at(32, {.cell = 0.3, .film = 0.6, .variation = 0.0}), 0.3, 1e-5);
    EXPECT_NEAR(at(51, {.cell = 0.3, .film = 0.6, .variation = 0.0}), 0.6, 1e-5);
    EXPECT_NEAR(at(32, {.cell = 0.3, .film = 0.6, .variation = 0.2}), 0.3, 0.1);
    EXPECT_EQ(at(1, {}), 0.0F);
}

TEST(CellMaps, ARangeOfPressuresIsMeasured) {
    Hexagons hexagons;
    hexagons.set_pressures({-0.5, 0.0, 0.5, 1.5});
    PressureOptions options;
    options.scaling = PressureScaling::Range;
    options.unit = PressureUnit::Seed;
    options.low = -0.5;
    options.high = 1.5;
    const std::vector<float> tones = hexagons.tones(options);
    // Films have no width: of pixels that bubbles share there are others in between.
    EXPECT_EQ(tones.front(), 0.0F);
    EXPECT_EQ(tones.back(), 1.0F);
    EXPECT_TRUE(std::any_of(
        tones.begin(), tones.end(), [](float tone) { return std::abs(tone - 0.25F) < 1e-5F; }));
    options.exaggeration = 3.0;  // 0.5 + 3 (t - 0.5), not held in 0 to 1
    EXPECT_EQ(hexagons.tones(options).front(), -1.0F);
    EXPECT_EQ(hexagons.tones(options).back(), 2.0F);
}

// Of the first frame's pressures 0, 1, ..., 100 the inner 80 % are 10 to 90; the ranks of 0 and 25
// are 0 and 1/4, between two pressures it is interpolated.
TEST(CellMaps, TonesAreThoseOfTheFirstFrame) {
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

TEST(CellMaps, WithoutAScaleTonesAreInTheMiddle) {
    Hexagons hexagons;
    for (const auto scaling : {PressureScaling::Percentile, PressureScaling::Rank}) {
        PressureOptions options;
        options.scaling = scaling;
        EXPECT_EQ(hexagons.tones(options), std::vector<float>{0.5F});
    }
}

// A share of bubbles has a share of ranks, whatever their pressures are.
TEST(CellMaps, RanksSpreadTonesEvenly) {
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

TEST(CellMaps, ColoursOfIdentitiesAreWithinSrgbAndFarApart) {
    for (BubbleIdentity identity = 0; identity < 10000; ++identity) {
        const LinearRgb color = identity_color(identity);
        for (const double channel : {color.r, color.g, color.b}) {
            ASSERT_GE(channel, 0.0) << identity;
            ASSERT_LE(channel, 1.0) << identity;
        }
        const LinearRgb next = identity_color(identity + 1);
        const double apart =
            std::abs(color.r - next.r) + std::abs(color.g - next.g) + std::abs(color.b - next.b);
        ASSERT_GT(apart, 0.15) << identity;
    }
}

TEST(CellMaps, ABubbleKeepsItsColour) {
    Circle circle;
    const ColorPixels image = draw_id_color(circle.layers);
    const LinearRgb color = identity_color(7);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[0] / 65535.0, color.r, 1e-5);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[1] / 65535.0, color.g, 1e-5);
    EXPECT_NEAR(image.pixels.pixel(32, 32)[2] / 65535.0, color.b, 1e-5);
    EXPECT_EQ(image.pixels.pixel(32, 32)[3], 65535);
}

}  // namespace
}  // namespace foam::texgen
