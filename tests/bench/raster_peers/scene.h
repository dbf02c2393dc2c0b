// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/coverage/fill.h"

#include <array>
#include <cstdint>
#include <vector>

namespace foam::bench {

/// A curve as a chain of straight edges, in pixels.
using Polyline = std::vector<Vec2>;

/// A frame on a torus for libraries that have no periodic images: all lattice copies of cells and
/// films that are visible in the image.
struct Scene {
    struct Cell {
        std::size_t bubble = 0;
        Polyline outline;
    };
    struct Film {
        // The index of the bubble on each side; -1 if the copy of its cell that touches this copy
        // of the film is not in `cells`.
        int left = -1;
        int right = -1;
        Polyline line;
    };
    int side = 0;  // side of the square image, pixels
    std::vector<Cell> cells;
    std::vector<Film> films;
    std::vector<std::array<std::uint8_t, 3>> colors;  // of the bubbles; films are white
};

inline constexpr double kFilmWidth = 2.0;  // pixels

/// Returns the scene of a frame. Polylines are within 1/32 pixel of their arcs. This is three times
/// as close as cairo's own approximation of arcs by default.
Scene scene_of(const Frame& frame, int side);

/// Returns the colors of the scene for our own rasterizer.
texgen::CellValues values_of(const Scene& scene);

}  // namespace foam::bench
