// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/vector/chain.h"

#include <vector>

namespace foam::texgen {

/// The part of an arc in one cell of a torus.
struct CellPiece {
    DrawnArc arc;        // moved into the fundamental cell, the tile
    LatticeOffset cell;  // the cell that contains the part before it is moved
};

/// Cuts an arc at the borders of the cells of a torus, in order from tail to head. If the arc
/// crosses a border, the coordinate of the crossing is exactly 0 on one side of the border and
/// exactly the width or the height of the torus on the other side; the other coordinates are equal
/// if the torus is not sheared. An arc in one cell is one piece, whose half angle is that of the
/// arc. Precondition: `torus` is not the plane, and the arc turns by less than 360 degrees.
std::vector<CellPiece> cut_at_cells(const DrawnArc& arc, const Domain& torus);

/// Returns the parts of a closed chain in the cells of a torus, moved into the tile. Each part is
/// closed along the border of its cell. Precondition: the chain is counter-clockwise and does not
/// cross itself.
std::vector<Chain> closed_in_cells(const Chain& chain, const Domain& torus);

/// Returns the region to the left of closed chains inside the tile [0, width] x [0, height], closed
/// along the border of the tile. Precondition: the chains do not cross each other.
std::vector<Chain> clipped_to_tile(const std::vector<Chain>& chains, double width, double height);

}  // namespace foam::texgen
