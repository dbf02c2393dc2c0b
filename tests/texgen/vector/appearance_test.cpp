// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/appearance.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace foam::texgen {
namespace {

TEST(Appearance, AutoIsWhatTheFirstMapShows) {
    const VectorOptions options;
    EXPECT_EQ(shown_content(options, {"albedo", "maze"}), VectorContent::Foam);
    EXPECT_EQ(shown_content(options, {"maze", "albedo"}), VectorContent::Maze);
    EXPECT_EQ(shown_content(options, {"maze_solution"}), VectorContent::MazeSolution);
    EXPECT_EQ(shown_content(options, {"contour"}), VectorContent::Contour);
    EXPECT_EQ(shown_content({.content = VectorContent::Foam}, {"maze"}), VectorContent::Foam);
}

TEST(Appearance, OutlinesNeedAWidth) {
    MapOptions maps;
    maps.albedo.film_width = 0.0;
    maps.maze.wall_width = 0.0;
    VectorOptions options{.walls = VectorWalls::Outlines};
    EXPECT_THROW(check_width(VectorContent::Foam, maps, options), std::invalid_argument);
    EXPECT_THROW(check_width(VectorContent::Maze, maps, options), std::invalid_argument);
    options.wall_width = 1.0;
    EXPECT_NO_THROW(check_width(VectorContent::Foam, maps, options));
    options = {};
    EXPECT_NO_THROW(check_width(VectorContent::Maze, maps, options));
}

}  // namespace
}  // namespace foam::texgen
