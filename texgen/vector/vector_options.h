// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// What a drawing shows.
enum class VectorContent {
    Auto,          // what the first map of image.maps shows: a maze, contours, or else the foam
    Foam,          // bubbles in the colors of the map albedo, and films
    Maze,          // the walls of the map maze
    MazeSolution,  // the walls, and the solution
    Contour,       // the lines of the map contour
};

/// How films, walls of mazes and contour lines are drawn.
enum class VectorWalls {
    Lines,     // center lines, joined into chains, with a stroke
    Outlines,  // the outlines of walls of a given width, as closed chains
};

/// What a drawing shows at the border of the tile of a torus.
enum class VectorWrap {
    Cut,    // everything is cut at the border, so that copies of the drawing tile
    Whole,  // bubbles are whole; those at the border extend beyond it
};

/// The options of drawings: SVG, DXF and PDF files.
struct VectorOptions {
    VectorContent content = VectorContent::Auto;
    double width_mm = 100.0;  // width of the drawing
    VectorWalls walls = VectorWalls::Lines;
    // The full width of lines and walls in millimeters; 0 for the width that the map draws.
    double wall_width = 0.0;
    VectorWrap wrap = VectorWrap::Cut;
};

Keys<VectorOptions> vector_keys();

}  // namespace foam::texgen
