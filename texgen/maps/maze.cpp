// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/film_strokes.h"
#include "texgen/maps/maze_line.h"

#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace foam::texgen {

Keys<MazeOptions> maze_keys() {
    using Options = MazeOptions;
    return {
        key("chance",
            kFractions,
            "weight of chance in the choice of the films that are opened: with 0, passages follow "
            "bubbles of similar pressure; with 1, they are random",
            &Options::chance),
        key("seed",
            Integers{0, std::numeric_limits<std::int64_t>::max()},
            "seed of the random choices",
            &Options::seed),
        key("loops",
            kFractions,
            "fraction of the walls between bubbles that are opened to make loops; with 0, exactly "
            "one path connects any two bubbles of a torus or of a raft",
            &Options::loops)
            .in("fraction of the walls"),
        key("wall_width",
            Reals{0.0, 10.0},
            "full width of walls, in diameters of a mean bubble of the seeded foam; films shorter "
            "than 1.5 times this width, or beside a bubble smaller than a circle of that "
            "diameter, are opened last",
            &Options::wall_width)
            .in("mean bubble diameters of the seeded foam"),
        key("wall_color", Colors{}, "sRGB color of walls", &Options::wall_color)
            .unused_with("maze.wall_width", {"0.0"}),
        key("passage_color", Colors{}, "sRGB color of passages", &Options::passage_color),
        key("solution_width",
            Reals{0.0, 10.0},
            "full width of the line that the map maze_solution draws, in diameters of a mean "
            "bubble of the seeded foam",
            &Options::solution_width)
            .in("mean bubble diameters of the seeded foam"),
        key("solution_color", Colors{}, "sRGB color of the solution", &Options::solution_color)
            .unused_with("maze.solution_width", {"0.0"})};
}

MazeRule maze_rule(const MazeOptions& options) {
    // Walls end in half disks, so the gap at an open film is the length of the film minus the width
    // of a wall. A film with a gap smaller than kSmallestGap counts as narrow.
    constexpr double kSmallestGap = 0.5;                     // in widths of a wall
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;  // of a mean bubble, in foam units
    const double width = options.wall_width * diameter;
    return {options.chance, options.seed, options.loops, (1.0 + kSmallestGap) * width};
}

Image<float> maze_wall_coverage(FrameLayers& layers, const MazeOptions& options) {
    const double width =
        diameters_in_pixels(options.wall_width, layers.grid(), layers.frame().domain);
    return stroke_coverage(layers.wall_distances(maze_rule(options), stroke_needs(width)).distance,
                           width);
}

ColorPixels draw_maze(FrameLayers& layers, const MazeOptions& options) {
    return paint_layers(
        layers,
        options.passage_color,
        std::array{PaintLayer{options.wall_color, maze_wall_coverage(layers, options)}});
}

ColorPixels draw_maze_solution(FrameLayers& layers, const MazeOptions& options) {
    const Maze& maze = layers.maze(maze_rule(options));
    const double scale = pixels_per_unit(layers.grid(), layers.frame().domain);
    const std::vector<PlacedArc> line = solution_line(layers.frame(), maze.solution, scale);
    return paint_layers(
        layers,
        options.passage_color,
        std::array{PaintLayer{options.wall_color, maze_wall_coverage(layers, options)},
                   PaintLayer{options.solution_color,
                              strokes_along(layers, line, options.solution_width)}});
}

}  // namespace foam::texgen
