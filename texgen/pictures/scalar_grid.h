// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Numbers at the points of a square grid, whose spacing is 1: number (x, y) is at the point (x, y)
/// of the plane. Row 0 is the bottom row. Beyond the grid, all numbers count as 0.
struct ScalarGrid {
    int width = 0;
    int height = 0;
    std::vector<float> numbers{};  // row by row

    ScalarGrid(int grid_width, int grid_height)
        : width(grid_width),
          height(grid_height),
          numbers(static_cast<std::size_t>(grid_width) * static_cast<std::size_t>(grid_height)) {}

    float& operator()(int x, int y) { return numbers[index(x, y)]; }
    float operator()(int x, int y) const { return numbers[index(x, y)]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// The largest number of points of a grid from which an outline is traced: a square grid then has
/// 1448 points along its side.
inline constexpr double kOutlineGridPoints = 2097152.0;

}  // namespace foam::texgen
