// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/coverage/fill.h"

#include <array>
#include <cstdint>
#include <vector>

namespace foam::bench {

/// A straightened curve; pixels.
using Polyline = std::vector<Vec2>;

/// A frame on a torus as programs take it that know no torus: all that shows in the image, in as
/// many copies as show.
struct Scene {
    struct Cell {
        std::size_t bubble = 0;
        Polyline outline;
    };
    struct Film {
        int left = -1;  // bubbles, where that cell is one of `cells`
        int right = -1;
        Polyline line;
    };
    int side = 0;  // of the image, which is square
    std::vector<Cell> cells;
    std::vector<Film> films;
    std::vector<std::array<std::uint8_t, 3>> colors;  // of bubbles; light, as films are white
};

inline constexpr double kFilmWidth = 2.0;

/// Lines lie within 1/32 pixel of their arcs: three times as close as cairo's own arcs by default.
Scene scene_of(const Frame& frame, int side);

/// The same colors for our own rasterizer.
texgen::CellValues values_of(const Scene& scene);

}  // namespace foam::bench
