// SPDX-License-Identifier: Apache-2.0

#include "core/foam/honeycomb.h"
#include "tests/support/albedo_image.h"
#include "tests/support/sample_foams.h"
#include "texgen/image/color.h"
#include "texgen/image/colormap.h"
#include "texgen/raster/coverage/fill.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {
namespace {

// Returns a foam of four bubbles on a torus of area 4. The pressures are given values, not those of
// an equilibrium.
Frame four_bubbles(int size) {
    Frame frame = test::fitted_frame(honeycomb(2, 2), size, size);
    frame.film_tension = 0.5;
    double pressure = -0.3;
    for (FrameBubble& bubble : frame.bubbles) {
        bubble.pressure = pressure;
        pressure += 0.17;
    }
    return frame;
}

Srgb8 color_at(const Image<std::uint8_t>& image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

// Returns the color of a pixel well within a bubble.
Srgb8 color_inside(const Frame& frame, BubbleId bubble, const Image<std::uint8_t>& image) {
    Vec2 at = frame.positions[frame.network.tail(frame.network.first(bubble))];
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        sum += at;
        at += frame.arc(h).chord;
    }
    const Vec2 center = sum / frame.network.sides(bubble) * (image.width() / frame.domain.width);
    return color_at(image,
                    wrap(static_cast<int>(std::floor(center.x())), image.width()),
                    wrap(static_cast<int>(std::floor(center.y())), image.height()));
}

TEST(Albedo, ColorsTheEntriesOfTheMapExactly) {
    // Each pressure selects an entry of the color map. The conversion of its code to light and back
    // must be exact.
    Frame frame = four_bubbles(40);
    AlbedoOptions options;
    options.pressure_unit = PressureUnit::Seed;
    options.pressure_low = 0.0;
    options.pressure_high = 255.0;
    for (int first = 0; first < 256; first += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            // In units of the film tension T, the pressure is the index of the entry.
            frame.bubbles[id_at<BubbleId>(k)].pressure = 0.5 * (first + static_cast<double>(k));
        }
        const Image<std::uint8_t> image = test::albedo_image(frame, {40, 40, 0, 0}, options, 1);
        for (std::size_t k = 0; k < 4; ++k) {
            const int entry = first + static_cast<int>(k);
            EXPECT_EQ(color_inside(frame, id_at<BubbleId>(k), image),
                      find_colormap("viridis").entry(entry));
        }
    }
}

TEST(Albedo, MeasuresPressureInTheFramesOwnMeanArea) {
    // A torus of area 16 with four bubbles has the mean area 4. The pressure in this unit is p
    // sqrt(4) / T.
    Frame frame = four_bubbles(40);
    const double grown = 2.0 / std::sqrt(frame.domain.area() / 4.0);
    frame.domain.width *= grown;
    frame.domain.height *= grown;
    for (Vec2& position : frame.positions) {
        position *= grown;
    }
    for (FilmArc& arc : frame.arcs) {
        arc.chord *= grown;
    }
    AlbedoOptions options;
    options.pressure_low = 0.0;
    options.pressure_high = 255.0;
    frame.bubbles[id_at<BubbleId>(2)].pressure = 100.0 * 0.5 / 2.0;
    const Image<std::uint8_t> image = test::albedo_image(frame, {40, 40, 0, 0}, options, 1);
    EXPECT_EQ(color_inside(frame, id_at<BubbleId>(2), image), find_colormap("viridis").entry(100));
}

TEST(Albedo, PressuresBeyondTheRangeTakeItsEnds) {
    Frame frame = four_bubbles(40);
    frame.bubbles[id_at<BubbleId>(0)].pressure = -99.0;
    frame.bubbles[id_at<BubbleId>(1)].pressure = 99.0;
    const Image<std::uint8_t> image = test::albedo_image(frame, {40, 40, 0, 0}, {}, 1);
    EXPECT_EQ(color_inside(frame, id_at<BubbleId>(0), image), find_colormap("viridis").entry(0));
    EXPECT_EQ(color_inside(frame, id_at<BubbleId>(1), image), find_colormap("viridis").entry(255));
}

TEST(Albedo, FilmsHaveTheirColor) {
    const Frame frame = four_bubbles(64);
    AlbedoOptions options;
    options.film_color = "#12ab7f";
    options.film_width = 1000.0;  // films cover the whole image
    const Image<std::uint8_t> image = test::albedo_image(frame, {64, 64, 0, 0}, options, 1);
    for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(color_at(image, x, 17), (Srgb8{0x12, 0xab, 0x7f}));
    }
}

// Every pixel has the mean linear light of the cells and films in it, weighted by area.
TEST(Albedo, MixesLight) {
    const Frame frame = four_bubbles(64);
    AlbedoOptions options;
    options.film_width = 3.0;
    options.film_color = "#ff8000";
    const Image<std::uint8_t> image = test::albedo_image(frame, {64, 64, 0, 0}, options, 1);
    const CellArcs cells = cell_arcs(frame, {64, 64, 0, 0}, 3.0, 1);
    CellValues values{4, std::vector<std::uint16_t>(16, 0), {}};
    for (std::size_t k = 0; k < 4; ++k) {
        values.bubbles[5 * k] = 65535;
    }
    Image<std::uint16_t> parts(64, 64, 4);
    fill_cells(cells, values, 1, parts.view());
    const LinearRgb film = to_linear(parse_color(options.film_color));
    const double unit = std::sqrt(frame.domain.area() / 4.0) / frame.film_tension;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            LinearRgb mix = film;
            for (std::size_t k = 0; k < 4; ++k) {
                const double pressure = frame.bubbles[id_at<BubbleId>(k)].pressure * unit;
                const LinearRgb cell = find_colormap("viridis").at(pressure + 0.5);
                const double part = parts.pixel(x, y)[k] / 65535.0;
                mix.r += part * (cell.r - film.r);
                mix.g += part * (cell.g - film.g);
                mix.b += part * (cell.b - film.b);
            }
            const Srgb8 expected = to_srgb8(mix);
            const Srgb8 found = color_at(image, x, y);
            // The light is rounded to 16 bits. If it is close to the border between two codes,
            // either code may result.
            EXPECT_NEAR(found.r, expected.r, 1);
            EXPECT_NEAR(found.g, expected.g, 1);
            EXPECT_NEAR(found.b, expected.b, 1);
        }
    }
}

TEST(Albedo, MeasuresWidthInPixelsOrDiameters) {
    AlbedoOptions options;
    options.film_width = 0.25;
    EXPECT_EQ(film_width_in_pixels(options, {100, 100, 0, 0}, {2.0, 2.0}), 0.25);
    // A circle of area 1 has the diameter 2 / sqrt(pi). The scale is 50 pixels per unit.
    options.film_unit = WidthUnit::Diameters;
    EXPECT_NEAR(film_width_in_pixels(options, {100, 100, 0, 0}, {2.0, 2.0}),
                0.25 * 50.0 * 2.0 / std::sqrt(std::numbers::pi),
                1e-12);
}

TEST(Albedo, DoesNotDependOnThreads) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(60, 3), 128, 128);
    const Image<std::uint8_t> one = test::albedo_image(frame, {128, 128, 0, 0}, {}, 1);
    EXPECT_EQ(one, test::albedo_image(frame, {128, 128, 0, 0}, {}, 2));
    EXPECT_EQ(one, test::albedo_image(frame, {128, 128, 0, 0}, {}, 3));
}

TEST(Albedo, RejectsUnreadableValues) {
    const Frame frame = four_bubbles(16);
    AlbedoOptions options;
    options.pressure_high = options.pressure_low;
    EXPECT_THROW(test::albedo_image(frame, {16, 16, 0, 0}, options, 1), std::invalid_argument);
    options = {};
    options.film_color = "white";
    EXPECT_THROW(test::albedo_image(frame, {16, 16, 0, 0}, options, 1), std::invalid_argument);
    options = {};
    options.colormap = "no such map";
    EXPECT_THROW(test::albedo_image(frame, {16, 16, 0, 0}, options, 1), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
