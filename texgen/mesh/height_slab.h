// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Heights above z = 0 at the points of a rectangular grid, in millimeters.
struct HeightField {
    std::vector<float> x;  // x of each column, ascending
    std::vector<float> y;  // y of each row, ascending
    std::vector<float> z;  // height of each point, row by row

    float at(std::size_t column, std::size_t row) const { return z[row * x.size() + column]; }
};

/// Returns the number of triangles of a slab over a grid of points with the given numbers of
/// columns and rows. Precondition: there are at least two columns and two rows.
std::size_t slab_triangles(std::size_t columns, std::size_t rows);

/// Returns a slab: the surface through the heights, vertical sides and a flat bottom at z = 0. Each
/// rectangle of the grid is divided along the diagonal whose ends differ less in height, so that
/// ridges and valleys are not serrated. Precondition: there are at least two columns and two rows,
/// and all heights are positive.
Mesh height_slab(const HeightField& field);

}  // namespace foam::texgen
