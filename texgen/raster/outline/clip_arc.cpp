// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/clip_arc.h"

#include "texgen/raster/arcs/arc_crossings.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// Returns the part of a piece between the heights `low` and `high`. Precondition: both are between
// the heights of the ends of the piece.
MonotonePieces::Piece between(const MonotonePieces::Piece& piece, double low, double high) {
    const CrossingSolver<double> arc(piece.head - piece.tail, piece.sine);
    const auto point_at = [&](double y) {
        return Vec2(piece.tail.x() + arc.x_at(y - piece.tail.y()), y);
    };
    MonotonePieces::Piece part{low > piece.tail.y() ? point_at(low) : piece.tail,
                               high < piece.head.y() ? point_at(high) : piece.head};
    const double half_curvature = piece.sine / (piece.head - piece.tail).norm();
    part.sine = half_curvature * (part.head - part.tail).norm();
    return part;
}

// Returns the height at which a piece crosses the vertical line at x. If the piece does not cross
// the line, returns the height of the end that is nearest to the line.
double height_at(const MonotonePieces::Piece& piece, double x) {
    const double from = piece.tail.x();
    const double to = piece.head.x();
    if (x <= std::min(from, to) || std::max(from, to) <= x) {
        return (x <= std::min(from, to)) == (from < to) ? piece.tail.y() : piece.head.y();
    }
    const CrossingSolver<double> arc(piece.head - piece.tail, piece.sine);
    const double y = piece.tail.y() + arc.y_at(x - piece.tail.x());
    return std::clamp(y, piece.tail.y(), piece.head.y());
}

}  // namespace

ClippedPiece::ClippedPiece(const MonotonePieces::Piece& piece, const Vec2& low, const Vec2& high) {
    const double from = std::max(piece.tail.y(), low.y());
    const double to = std::min(piece.head.y(), high.y());
    if (from < to) {
        clip_in_x(between(piece, from, to), low.x(), high.x());
    }
}

void ClippedPiece::clip_in_x(const MonotonePieces::Piece& piece, double left, double right) {
    const double at_left = height_at(piece, left);
    const double at_right = height_at(piece, right);
    if (piece.tail.x() < piece.head.x()) {
        append({{left, piece.tail.y()}, {left, at_left}});
        append(between(piece, at_left, at_right));
    } else {
        append(between(piece, at_right, at_left));
        append({{left, at_left}, {left, piece.head.y()}});
    }
}

void ClippedPiece::append(const MonotonePieces::Piece& piece) {
    if (piece.tail.y() < piece.head.y()) {
        pieces_[count_++] = piece;
    }
}

}  // namespace foam::texgen
