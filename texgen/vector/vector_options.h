// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The content of a drawing.
enum class VectorContent {
    Auto,          // decided by the first of image.maps: Maze for the map maze, MazeSolution for
                   // maze_solution, Contour for contour, and Foam for any other map
    Foam,          // bubbles in the colors of the map albedo, and films
    Maze,          // the walls of the map maze
    MazeSolution,  // the walls of the map maze, and the solution
    Contour,       // the lines of the map contour
};

/// The style in which films, walls of mazes and contour lines are drawn.
enum class VectorWalls {
    Lines,     // center lines, joined into chains, with a stroke
    Outlines,  // the outlines of walls of a given width, as closed chains
};

/// The treatment of bubbles and films at the border of the tile of a torus.
enum class VectorWrap {
    Cut,    // everything is cut at the border, so that copies of the drawing tile
    Whole,  // bubbles are whole; those at the border extend beyond it
};

/// The options of drawings: SVG, DXF and PDF files. Meshes use all of them except `walls`.
struct VectorOptions {
    VectorContent content = VectorContent::Auto;
    double width_mm = 100.0;  // width of the tile or of the view
    VectorWalls walls = VectorWalls::Lines;
    // The full width of lines and walls in millimeters; 0 for the width that the map draws.
    double wall_width = 0.0;
    VectorWrap wrap = VectorWrap::Cut;
};

/// Returns the keys of the table `vector` of a preset, without the prefix "vector.".
Keys<VectorOptions> vector_keys();

}  // namespace foam::texgen
