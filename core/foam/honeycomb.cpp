// SPDX-License-Identifier: Apache-2.0

#include "core/foam/honeycomb.h"

#include "core/foam/cell_diagram.h"
#include "core/geometry/elementary.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace foam {

namespace {

// Returns the steps (column, row) from a hexagon of the given row to its six neighbors,
// counter-clockwise, beginning with the neighbor on the right. Hexagons have a corner at the top.
// Odd rows are shifted to the right by half of the width of a hexagon.
std::array<std::array<int, 2>, 6> neighbor_steps(int row) {
    const int shift = row % 2;
    return {{{1, 0}, {shift, 1}, {shift - 1, 1}, {-1, 0}, {shift - 1, -1}, {shift, -1}}};
}

// Returns a / b, rounded down. Precondition: b is positive.
int floor_div(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Returns the corners of a hexagon of the given side length. The neighbor at step k of
// neighbor_steps is across the side from corner k to the next corner.
std::vector<CellCorner> hexagon(int column, int row, int columns, int rows, double side) {
    constexpr double kPi = 3.14159265358979323846;
    const double width = std::sqrt(3.0) * side;
    const Vec2 center(width * (column + 0.5 * (row % 2) + 0.5), side * (1.5 * row + 1.0));
    const auto steps = neighbor_steps(row);
    std::vector<CellCorner> corners;
    for (std::size_t k = 0; k < 6; ++k) {
        const double angle = kPi / 6.0 * (2.0 * static_cast<double>(k) - 1.0);
        const int c = column + steps[k][0];
        const int r = row + steps[k][1];
        const LatticeOffset offset{floor_div(c, columns), floor_div(r, rows)};
        const int across = (r - offset.j * rows) * columns + (c - offset.i * columns);
        corners.push_back(
            {center + side * unit_vector(angle), static_cast<std::size_t>(across), offset});
    }
    return corners;
}

}  // namespace

Foam honeycomb(int columns, int rows) {
    if (columns < 1 || rows < 2 || rows % 2 != 0) {
        throw std::invalid_argument(
            "a honeycomb needs at least one column and a positive, even number of rows");
    }
    const double side = std::sqrt(2.0 / (3.0 * std::sqrt(3.0)));
    const Domain domain{std::sqrt(3.0) * side * columns, 1.5 * side * rows};
    CellDiagram cells;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            cells.push_back(hexagon(column, row, columns, rows, side));
        }
    }
    return foam_from_cells(domain, cells);
}

}  // namespace foam
