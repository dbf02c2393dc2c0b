// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_strokes.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/albedo_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ArcsOfFilms, AreTheChosenFilmsAndTheCirclesOfLoneBubbles) {
    const test::MapSubject& patch = test::patch_subject();
    const FrameLayers layers(patch.input(), test::patch_grid(64), 1);
    const std::size_t circles = 2 * patch.frame.lone_bubbles.size();
    EXPECT_EQ(circles, 2U);
    EXPECT_EQ(arcs_of_films(layers, [](FilmId) { return false; }).size(), circles);
    std::vector<FilmId> films;
    for (const FilmId film : patch.frame.network.films()) {
        films.push_back(film);
    }
    EXPECT_EQ(arcs_of_films(layers, [](FilmId) { return true; }).size(), films.size() + circles);
    const std::vector<PlacedArc> one =
        arcs_of_films(layers, [&](FilmId film) { return film == films[3]; });
    ASSERT_EQ(one.size(), 1 + circles);
    const double scale = pixels_per_unit(layers.grid(), patch.frame.domain);
    const HalfEdgeId side = forward_side(films[3]);
    EXPECT_EQ(one.front().tail, patch.frame.positions[patch.frame.network.tail(side)]);
    EXPECT_LT((one.front().arc.chord - scale * patch.frame.arc(side).chord).norm(), 1e-9);
}

// Both half circles around a lone bubble have their ends on its boundary, and their middles are
// above and below its center.
TEST(ArcsOfFilms, ALoneBubbleIsTwoHalfCircles) {
    const test::MapSubject& patch = test::patch_subject();
    const FrameLayers layers(patch.input(), test::patch_grid(64), 1);
    const double scale = pixels_per_unit(layers.grid(), patch.frame.domain);
    const LoneBubble& bubble = patch.frame.lone_bubbles.front();
    const double radius = std::sqrt(bubble.target_area / std::numbers::pi);
    const std::vector<PlacedArc> halves = arcs_of_films(layers, [](FilmId) { return false; });
    for (const PlacedArc& half : halves) {
        EXPECT_NEAR((half.tail - bubble.center).norm(), radius, 1e-9 * radius);
        for (const double angle : {0.3, 1.2, 2.9, 4.4, 6.0}) {
            const Vec2 direction(std::cos(angle), std::sin(angle));
            const Vec2 point = scale * (bubble.center + radius * direction - half.tail);
            const bool is_above = direction.y() > 0.0;
            const bool covers = is_above == (half.tail.x() > bubble.center.x());
            EXPECT_EQ(nearest_on_arc(half.arc, point).distance < 1e-6, covers) << angle;
        }
    }
}

// The width of a stroke is given in diameters of a mean bubble, whose area is 1. A horizontal
// stroke of length 2 covers 2 x width plus a disk at its ends.
TEST(StrokesAlong, HaveTheGivenWidth) {
    constexpr int kSide = 128;
    const Frame frame = foam::test::fitted_frame(honeycomb(4, 4), kSide, kSide);
    const FoamRecord record;
    const FrameLayers layers({frame, record}, {kSide, kSide}, 1);
    const double scale = pixels_per_unit(layers.grid(), frame.domain);
    const std::vector<PlacedArc> line = {{{1.0, 1.0}, {{2.0 * scale, 0.0}, 1.0, 0.0}}};
    const double diameter = 2.0 / std::sqrt(std::numbers::pi);
    for (const double width : {0.1, 0.4}) {
        const Image<float> image = strokes_along(layers, line, width / diameter);
        const double covered =
            std::accumulate(image.samples().begin(), image.samples().end(), 0.0) / (scale * scale);
        EXPECT_NEAR(covered, 2.0 * width + 0.25 * std::numbers::pi * width * width, 0.01) << width;
    }
}

Image<float> even_layer(int side, float part) {
    Image<float> image(side, side, 1);
    std::ranges::fill(image.samples(), part);
    return image;
}

// On a torus a later layer covers the earlier ones, and colors are mixed as linear light.
TEST(PaintLayers, LaterLayersCoverEarlierOnes) {
    const test::MapSubject& torus = test::torus_subject();
    FrameLayers layers(torus.input(), test::torus_grid(8), 1);
    const std::array over = {PaintLayer{"#ffffff", even_layer(8, 1.0F)},
                             PaintLayer{"#ff0000", even_layer(8, 0.25F)}};
    const ColorPixels painted = paint_layers(layers, "#000000", over);
    ASSERT_EQ(painted.pixels.channels(), 3);
    const auto pixel = painted.pixels.pixel(3, 5);
    EXPECT_EQ(pixel[0], to_sample(1.0));
    EXPECT_EQ(pixel[1], to_sample(0.75));
    EXPECT_EQ(pixel[2], to_sample(0.75));
}

// Around a patch, pixels have the opacity and the color of the layers alone.
TEST(PaintLayers, AroundAPatchOnlyLayersAreVisible) {
    const test::MapSubject& patch = test::patch_subject();
    FrameLayers layers(patch.input(), test::patch_grid(32), 1);
    const std::array over = {PaintLayer{"#ff0000", even_layer(32, 0.5F)}};
    const ColorPixels painted = paint_layers(layers, "#0000ff", over);
    ASSERT_EQ(painted.pixels.channels(), kChannelsWithOpacity);
    const auto corner = painted.pixels.pixel(0, 0);
    EXPECT_EQ(corner[0], to_sample(1.0));
    EXPECT_EQ(corner[2], 0);
    EXPECT_EQ(corner[3], to_sample(0.5));
}

}  // namespace
}  // namespace foam::texgen
