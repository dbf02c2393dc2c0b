// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// Clips a rising monotone piece of an arc to a box. The part inside the box is kept. The part to
/// the left of the box is replaced by the part of the left border of the box at the same heights,
/// because an arc affects all pixels on its right. The parts above, below and to the right of the
/// box are dropped.
class ClippedPiece {
  public:
    /// `low` is the lower left corner of the box, `high` the upper right corner. Precondition: the
    /// piece rises.
    ClippedPiece(const MonotonePieces::Piece& piece, const Vec2& low, const Vec2& high);

    /// Returns the pieces that replace the given piece, from low to high.
    std::span<const MonotonePieces::Piece> pieces() const {
        return std::span(pieces_).first(count_);
    }

  private:
    void append(const MonotonePieces::Piece& piece);
    void clip_in_x(const MonotonePieces::Piece& piece, double left, double right);

    std::array<MonotonePieces::Piece, 2> pieces_;
    std::size_t count_ = 0;
};

}  // namespace foam::texgen
