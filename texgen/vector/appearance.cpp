// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/appearance.h"

#include "texgen/maps/contour.h"

#include <fmt/core.h>

#include <stdexcept>

namespace foam::texgen {

namespace {

Appearance foam_appearance(const FrameLayers& layers, const AlbedoOptions& options) {
    return {"films",
            "film",
            options.film_color,
            film_width_in_pixels(options, layers.grid(), layers.frame().domain),
            "",
            [](FilmId) { return true; }};
}

Appearance maze_appearance(FrameLayers& layers, const MazeOptions& options) {
    const Maze& maze = layers.maze(maze_rule(options));
    return {"walls",
            "wall",
            options.wall_color,
            diameters_in_pixels(options.wall_width, layers.grid(), layers.frame().domain),
            options.passage_color,
            [&maze](FilmId film) { return maze.is_open[film] == 0; }};
}

Appearance contour_appearance(const FrameLayers& layers, const MapOptions& maps) {
    return {"contours",
            "contour",
            maps.contour.line_color,
            diameters_in_pixels(maps.contour.width, layers.grid(), layers.frame().domain),
            maps.contour.ground_color,
            [chosen = contour_films(layers, maps.contour, maps.pressure)](FilmId film) {
                return chosen[film] != 0;
            }};
}

}  // namespace

VectorContent shown_content(const VectorOptions& options, const std::vector<std::string>& maps) {
    if (options.content != VectorContent::Auto) {
        return options.content;
    }
    for (const VectorContent content :
         {VectorContent::Maze, VectorContent::MazeSolution, VectorContent::Contour}) {
        if (maps.front() == name_of(content)) {
            return content;
        }
    }
    return VectorContent::Foam;
}

std::string_view name_of(VectorContent content) {
    switch (content) {
        case VectorContent::Maze:
            return kMazeMap.name;
        case VectorContent::MazeSolution:
            return kMazeSolutionMap.name;
        case VectorContent::Contour:
            return kContourMap.name;
        default:
            return "foam";
    }
}

namespace {

void require_width(double width, const char* key, const char* remedy) {
    if (!(width > 0.0)) {
        throw std::invalid_argument(
            fmt::format("outlines and walls need a width, but {} is 0; {}", key, remedy));
    }
}

}  // namespace

void check_wall_width(VectorContent content, const MapOptions& maps, const VectorOptions& options) {
    if (options.wall_width > 0.0) {
        return;
    }
    constexpr const char* kRemedy = "set it or vector.wall_width";
    if (content == VectorContent::Foam) {
        require_width(maps.albedo.film_width, "albedo.film_width", kRemedy);
    } else if (content == VectorContent::Contour) {
        require_width(maps.contour.width, "contour.width", kRemedy);
    } else {
        require_width(maps.maze.wall_width, "maze.wall_width", kRemedy);
    }
}

void check_width(VectorContent content, const MapOptions& maps, const VectorOptions& options) {
    if (options.walls != VectorWalls::Outlines) {
        return;
    }
    if (content == VectorContent::MazeSolution) {
        require_width(maps.maze.solution_width, "maze.solution_width", "set it");
    }
    check_wall_width(content, maps, options);
}

double drawn_width(const Appearance& look, const Page& page, const VectorOptions& options) {
    return options.wall_width > 0.0 ? options.wall_width : look.map_width * page.pixel;
}

Appearance appearance_of(FrameLayers& layers, VectorContent content, const MapOptions& maps) {
    switch (content) {
        case VectorContent::Maze:
        case VectorContent::MazeSolution:
            return maze_appearance(layers, maps.maze);
        case VectorContent::Contour:
            return contour_appearance(layers, maps);
        default:
            return foam_appearance(layers, maps.albedo);
    }
}

}  // namespace foam::texgen
