// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze.h"

#include "core/foam/measure.h"
#include "texgen/image/bleed.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/arc_distance.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/maze_line.h"
#include "texgen/raster/arcs/film_arcs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

double scale_of(const FrameLayers& layers) {
    return pixels_per_unit(layers.grid(), layers.frame().domain);
}

// Returns the arcs of the films that are walls, and the circles of lone bubbles, two arcs each.
std::vector<PlacedArc> walls_of(const FrameLayers& layers, const Maze& maze) {
    const Frame& frame = layers.frame();
    const std::vector<PixelArc> arcs = film_arcs(frame, scale_of(layers), layers.threads());
    std::vector<PlacedArc> walls;
    for (const FilmId film : frame.network.films()) {
        if (maze.is_open[film] == 0) {
            const JunctionId tail = frame.network.tail(forward_side(film));
            walls.push_back({frame.positions[tail], arcs[index_of(film)]});
        }
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        const double radius = lone_radius(bubble);
        for (const double side : {-1.0, 1.0}) {
            const Vec2 tail = bubble.center + Vec2(side * radius, 0.0);
            const Vec2 chord(-2.0 * side * radius * scale_of(layers), 0.0);
            walls.push_back({tail, {chord, 0.0, 1.0}});
        }
    }
    return walls;
}

// Returns the fraction of every pixel that strokes along arcs cover. `width` is in diameters of a
// seeded mean bubble.
Image<float> coverage_of(const FrameLayers& layers,
                         const std::vector<PlacedArc>& arcs,
                         double width) {
    const Domain& domain = layers.frame().domain;
    return stroke_coverage(
        arcs, layers.grid(), domain, diameters_in_pixels(width, layers.grid(), domain));
}

// A layer of one color, and the fraction of every pixel that it covers.
struct Layer {
    LinearRgb color;
    Image<float> coverage;
};

// Returns an image of layers over a ground. Around a patch pixels are transparent where no layer
// covers them.
ColorPixels blend(FrameLayers& layers, const LinearRgb& ground, const std::vector<Layer>& over) {
    const RasterGrid& grid = layers.grid();
    const Image<float> foam =
        layers.is_patch() ? fill_coverage(layers, Part::Foam, 0.0) : Image<float>();
    const std::size_t channels = layers.is_patch() ? 4 : 3;
    Image<std::uint16_t> image(grid.width, grid.height, static_cast<int>(channels));
    const std::size_t pixels = image.samples().size() / channels;
    for (std::size_t k = 0; k < pixels; ++k) {
        LinearRgb color = ground;
        double opacity = layers.is_patch() ? static_cast<double>(foam.samples()[k]) : 1.0;
        for (const Layer& layer : over) {
            const auto part = static_cast<double>(layer.coverage.samples()[k]);
            // Where the ground is missing, only the layer is visible.
            opacity = std::max(opacity, part);
            color = mixed(color, layer.color, opacity > 0.0 ? part / opacity : 0.0);
        }
        const auto pixel = image.samples().subspan(channels * k, channels);
        pixel[0] = to_sample(color.r);
        pixel[1] = to_sample(color.g);
        pixel[2] = to_sample(color.b);
        if (layers.is_patch()) {
            pixel[3] = to_sample(opacity);
        }
    }
    if (layers.is_patch()) {
        bleed_colors(image.view(), {to_sample(ground.r), to_sample(ground.g), to_sample(ground.b)});
    }
    return {std::move(image)};
}

LinearRgb light_of(const std::string& color) {
    return to_linear(parse_color(color));
}

Layer wall_layer(const FrameLayers& layers, const MazeOptions& options, const Maze& maze) {
    return {light_of(options.wall_color),
            coverage_of(layers, walls_of(layers, maze), options.wall_width)};
}

}  // namespace

Keys<MazeOptions> maze_keys() {
    using Options = MazeOptions;
    return {
        key("chance",
            kFractions,
            "share of chance in the choice of the films that are open: 0 leads passages along "
            "bubbles of similar pressure, 1 anywhere",
            &Options::chance),
        key("seed",
            Integers{0, std::numeric_limits<std::int64_t>::max()},
            "seed of the random choices",
            &Options::seed),
        key("loops",
            kFractions,
            "fraction of the walls that are opened in addition; 0 leaves exactly one way between "
            "any two bubbles",
            &Options::loops)
            .in("fraction of the walls"),
        key("wall_width",
            Reals{0.0, 10.0},
            "full width of walls, in diameters of a mean bubble of the seeded foam",
            &Options::wall_width)
            .in("mean bubble diameters of the seeded foam"),
        key("wall_color", Colors{}, "sRGB color of walls", &Options::wall_color),
        key("passage_color", Colors{}, "sRGB color of passages", &Options::passage_color),
        key("solution_width",
            Reals{0.0, 10.0},
            "full width of the line of maze_solution, in diameters of a mean bubble of the seeded "
            "foam",
            &Options::solution_width)
            .in("mean bubble diameters of the seeded foam"),
        key("solution_color", Colors{}, "sRGB color of the solution", &Options::solution_color)};
}

MazeRule maze_rule(const MazeOptions& options) {
    // Walls end in half disks, so the gap at an open film is its length minus the width of a wall.
    // A film whose gap is smaller than kSmallestGap counts as narrow.
    constexpr double kSmallestGap = 0.5;                     // in widths of a wall
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;  // of a mean bubble, in foam units
    const double width = options.wall_width * diameter;
    return {options.chance, options.seed, options.loops, (1.0 + kSmallestGap) * width};
}

ColorPixels draw_maze(FrameLayers& layers, const MazeOptions& options) {
    const Maze maze = find_maze(layers.frame(), maze_rule(options));
    return blend(layers, light_of(options.passage_color), {wall_layer(layers, options, maze)});
}

ColorPixels draw_maze_solution(FrameLayers& layers, const MazeOptions& options) {
    const Maze maze = find_maze(layers.frame(), maze_rule(options));
    const std::vector<PlacedArc> line =
        solution_line(layers.frame(), maze.solution, scale_of(layers));
    return blend(
        layers,
        light_of(options.passage_color),
        {wall_layer(layers, options, maze),
         {light_of(options.solution_color), coverage_of(layers, line, options.solution_width)}});
}

}  // namespace foam::texgen
