// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/tone_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

// A picture whose pixels are opaque and gray: `light` has their samples of light, the bottom row
// first.
SourcePicture gray_picture(int width, int height, const std::vector<std::uint16_t>& light) {
    SourcePicture picture{{width, height, 4}};
    for (std::size_t k = 0; k < light.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            picture.pixels.samples()[4 * k + c] = light[k];
        }
        picture.pixels.samples()[4 * k + 3] = 65535;
    }
    return picture;
}

ToneGrid grid_of(int columns, int rows, const std::vector<double>& tones) {
    ToneGrid grid(columns, rows, 1);
    std::ranges::copy(tones, grid.samples().begin());
    return grid;
}

TEST(ToneGrid, BlackIsOneAndWhiteIsZero) {
    const ToneGrid grid = darkness_of(gray_picture(2, 1, {0, 65535}), 10);
    EXPECT_EQ(grid.width(), 2);
    EXPECT_EQ(grid.height(), 1);
    EXPECT_NEAR(grid.pixel(0, 0)[0], 1.0, 1e-12);
    EXPECT_NEAR(grid.pixel(1, 0)[0], 0.0, 1e-12);
}

// The left cell has two black and two white pixels, so that its mean light is 0.5.
TEST(ToneGrid, AveragesTheLightOfManyPixels) {
    const ToneGrid grid = darkness_of(gray_picture(4, 2, {0, 65535, 0, 0, 65535, 0, 0, 0}), 2);
    EXPECT_EQ(grid.width(), 2);
    EXPECT_EQ(grid.height(), 1);
    EXPECT_NEAR(grid.pixel(0, 0)[0], 0.5, 1e-12);
    EXPECT_NEAR(grid.pixel(1, 0)[0], 1.0, 1e-12);
}

TEST(ToneGrid, StretchesTonesToTheWholeRange) {
    ToneGrid grid = grid_of(3, 1, {0.5, 0.4, 0.6});
    stretch_tones(grid);
    EXPECT_NEAR(grid.pixel(0, 0)[0], 0.5, 1e-12);
    EXPECT_EQ(grid.pixel(1, 0)[0], 0.0);
    EXPECT_EQ(grid.pixel(2, 0)[0], 1.0);
    ToneGrid flat = grid_of(2, 1, {0.7, 0.7});
    stretch_tones(flat);
    EXPECT_EQ(flat, grid_of(2, 1, {0.0, 0.0}));
}

TEST(ToneGrid, MirrorsBesideAndAbove) {
    const ToneGrid tiled = mirrored(grid_of(2, 2, {1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(tiled.width(), 4);
    EXPECT_EQ(
        tiled,
        grid_of(4,
                4,
                {1.0, 2.0, 2.0, 1.0, 3.0, 4.0, 4.0, 3.0, 3.0, 4.0, 4.0, 3.0, 1.0, 2.0, 2.0, 1.0}));
}

// The tones of each row rise from 0.2 to 0.8: a step at the edge of a tiled picture.
TEST(ToneGrid, BlendingRemovesAStepAtTheEdges) {
    ToneGrid grid(64, 3, 1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 64; ++column) {
            grid.pixel(column, row)[0] = 0.2 + 0.6 * column / 63.0;
        }
    }
    EXPECT_TRUE(has_visible_edges(grid));
    const double middle = grid.pixel(32, 1)[0];
    blend_edges(grid);
    EXPECT_FALSE(has_visible_edges(grid));
    EXPECT_NEAR(grid.pixel(0, 0)[0], 0.5, 1e-12);
    EXPECT_NEAR(grid.pixel(63, 0)[0], 0.5, 1e-12);
    EXPECT_EQ(grid.pixel(32, 1)[0], middle);
}

TEST(ToneGrid, APeriodicPictureHasNoVisibleEdges) {
    ToneGrid grid(64, 64, 1);
    for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
            grid.pixel(column, row)[0] =
                0.5 + 0.4 * std::sin(2.0 * std::numbers::pi * column / 64.0);
        }
    }
    EXPECT_FALSE(has_visible_edges(grid));
    EXPECT_FALSE(has_visible_edges(ToneGrid(1, 1, 1)));
}

}  // namespace
}  // namespace foam::texgen
