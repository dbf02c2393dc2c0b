// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// The pieces that replace a rising piece in a box. The part inside the box stays, the part to the
/// left of the box becomes a piece of the box's left border with the same heights, and all other
/// parts are dropped.
class ClippedPiece {
  public:
    /// `low` and `high` are the corners of the box. Precondition: the piece rises.
    ClippedPiece(const MonotonePieces::Piece& piece, const Vec2& low, const Vec2& high);

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
