// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/maze_graph.h"

#include <cstdint>
#include <string>

namespace foam::texgen {

inline constexpr MapTraits kMazeMap = {
    .name = "maze",
    .meaning = "maze of the foam: bubbles are rooms, films are walls or open",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .png_filter = PngFilter::Up};

inline constexpr MapTraits kMazeSolutionMap = {.name = "maze_solution",
                                               .meaning = "maze, and its solution as a smooth line",
                                               .unit = "light",
                                               .channels = "R G B",
                                               .kind = MapKind::Color,
                                               .png_filter = PngFilter::Up};

struct MazeOptions {
    // The weight of chance in the choice of the films to open. The weight of the difference of the
    // pressures on both sides of a film is 1 - chance.
    double chance = 0.4;
    std::int64_t seed = 1;  // seed of the random choices
    // After a maze without loops has been built, this fraction (0 to 1) of its walls between
    // bubbles is opened to make loops.
    double loops = 0.0;
    // The full width of walls, in diameters of a mean bubble of the seeded foam.
    double wall_width = 0.22;
    std::string wall_color = "#16262f";  // colors are sRGB
    std::string passage_color = "#f4efe2";
    // The full width of the line of the solution, in diameters of a mean bubble of the seeded foam.
    double solution_width = 0.26;
    std::string solution_color = "#e2472c";
};

Keys<MazeOptions> maze_keys();

/// Returns the rule by which the maps build their maze. MazeRule::narrow_length is one and a half
/// times the width of walls, in foam units. If a shorter film is opened, almost no gap is left
/// between the walls at its two ends.
MazeRule maze_rule(const MazeOptions& options);

/// Returns the fraction of every pixel that walls and the circles of lone bubbles cover, in one
/// channel.
Image<float> maze_wall_coverage(FrameLayers& layers, const MazeOptions& options);

/// Draws a maze (find_maze): passages, and walls with round ends along the films that are not
/// open. The circles of lone bubbles are drawn as walls, too. The surroundings of a patch are
/// transparent.
ColorPixels draw_maze(FrameLayers& layers, const MazeOptions& options);

/// Draws the maze and its solution: a smooth line through the middles of the films that the
/// solution passes. On a torus the line leads from the middle of one bubble to the middle of
/// another. On a patch it begins and ends in the middles of two outer films, the entrance and the
/// exit.
ColorPixels draw_maze_solution(FrameLayers& layers, const MazeOptions& options);

}  // namespace foam::texgen
