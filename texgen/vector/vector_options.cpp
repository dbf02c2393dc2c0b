// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/vector_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<VectorOptions> vector_keys() {
    using Options = VectorOptions;
    constexpr Choices<VectorContent, 5> kContents = {
        {{{"auto", VectorContent::Auto},
          {"foam", VectorContent::Foam},
          {"maze", VectorContent::Maze},
          {"maze_solution", VectorContent::MazeSolution},
          {"contour", VectorContent::Contour}}}};
    constexpr Choices<VectorWalls> kWalls = {
        {{{"lines", VectorWalls::Lines}, {"outlines", VectorWalls::Outlines}}}};
    constexpr Choices<VectorWrap> kWraps = {
        {{{"cut", VectorWrap::Cut}, {"whole", VectorWrap::Whole}}}};
    const std::vector<std::string> drawings = {"*.svg", "*.dxf", "*.pdf"};
    const std::vector<std::string> files = {"*.svg", "*.dxf", "*.pdf", "*.stl", "*.glb"};
    return {
        key("content",
            kContents,
            "what SVG, DXF and PDF files show, and which walls STL and GLB files have; with foam, "
            "bubbles have the colors of albedo; with auto, files show what the first of "
            "image.maps shows if it is maze, maze_solution or contour, else the foam",
            &Options::content)
            .used_with("output.pattern", files),
        key("width_mm",
            Reals{0.1, 100'000.0},
            "width in millimeters of the tile of a torus, or of the view of a patch, in drawings "
            "and meshes; the height follows from image.size",
            &Options::width_mm)
            .in("millimeters")
            .used_with("output.pattern", files),
        key("walls",
            kWalls,
            "how films, walls and contours are drawn: lines are center lines, joined into "
            "chains; outlines are the closed outlines of walls of the width vector.wall_width",
            &Options::walls)
            .used_with("output.pattern", drawings),
        key("wall_width",
            Reals{.low = 0.001, .high = 1000.0, .or_zero = true},
            "full width of lines and walls in millimeters; 0 takes the width that the map "
            "draws (albedo.film_width, maze.wall_width or contour.width)",
            &Options::wall_width)
            .in("millimeters")
            .used_with("output.pattern", files),
        key("wrap",
            kWraps,
            "border of the tile of a torus: with cut, all arcs are cut there, so that drawings "
            "tile; with whole, bubbles are whole and extend beyond the tile",
            &Options::wrap)
            .used_with("output.pattern", files)};
}

}  // namespace foam::texgen
