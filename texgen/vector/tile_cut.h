// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/vector/chain.h"

#include <vector>

namespace foam::texgen {

/// The part of an arc in one cell of a torus. The cells are the tile and its periodic copies.
struct CellPiece {
    DrawnArc arc;        // moved into the fundamental cell, the tile
    LatticeOffset cell;  // the cell that contains the part before it is moved
};

/// Cuts an arc at the borders of the cells of a torus. Returns the pieces in order from tail to
/// head. Where the arc crosses a border, one piece ends and the next one begins. There, the
/// coordinate across the border is exactly 0 in one piece, and exactly the width or the height of
/// the torus in the other. The coordinates along the border are equal if the torus is not sheared.
/// An arc in one cell is one piece with the same half angle. Precondition: `torus` is not the
/// plane, and the arc turns by less than 360 degrees.
std::vector<CellPiece> cut_at_cells(const DrawnArc& arc, const Domain& torus);

/// Cuts the region inside a closed chain at the borders of the cells of a torus. Returns the
/// outlines of the parts, moved into the tile. Each part is closed along the border of its cell.
/// Precondition: the chain is counter-clockwise and does not cross itself.
std::vector<Chain> closed_in_cells(const Chain& chain, const Domain& torus);

/// Returns the outline of the tile [0, width] x [0, height], counter-clockwise.
Chain tile_outline(double width, double height);

/// Returns the outlines of the part of a region that is inside the tile [0, width] x [0, height],
/// closed along the border of the tile. The region is on the left of the given closed chains.
/// Precondition: the chains do not cross each other.
std::vector<Chain> clipped_to_tile(const std::vector<Chain>& chains, double width, double height);

}  // namespace foam::texgen
