#include "texgen/raster/arcs/clip_arc.h"

#include "texgen/raster/arcs/rising_arc.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// The part of a piece between two heights, which it has.
RisingPiece between(const RisingPiece& piece, double low, double high) {
    const RisingArc arc(piece.high - piece.low, piece.sine);
    const auto point_at = [&](double y) {
        return Vec2(piece.low.x() + arc.x_at(y - piece.low.y()), y);
    };
    RisingPiece part{low > piece.low.y() ? point_at(low) : piece.low,
                     high < piece.high.y() ? point_at(high) : piece.high};
    const double half_curvature = piece.sine / (piece.high - piece.low).norm();
    part.sine = half_curvature * (part.high - part.low).norm();
    return part;
}

// The height at which a piece crosses an x, or that of its end on this side of it.
double height_at(const RisingPiece& piece, double x) {
    const double from = piece.low.x();
    const double to = piece.high.x();
    if (x <= std::min(from, to) || std::max(from, to) <= x) {
        return (x <= std::min(from, to)) == (from < to) ? piece.low.y() : piece.high.y();
    }
    const RisingArc arc(piece.high - piece.low, piece.sine);
    const double y = piece.low.y() + arc.y_at(x - piece.low.x());
    return std::clamp(y, piece.low.y(), piece.high.y());
}

}  // namespace

ClippedPiece::ClippedPiece(const RisingPiece& piece, const Vec2& low, const Vec2& high) {
    const double from = std::max(piece.low.y(), low.y());
    const double to = std::min(piece.high.y(), high.y());
    if (from < to) {
        clip_in_x(between(piece, from, to), low.x(), high.x());
    }
}

void ClippedPiece::clip_in_x(const RisingPiece& piece, double left, double right) {
    const double at_left = height_at(piece, left);
    const double at_right = height_at(piece, right);
    if (piece.low.x() < piece.high.x()) {
        append({{left, piece.low.y()}, {left, at_left}});
        append(between(piece, at_left, at_right));
    } else {
        append(between(piece, at_right, at_left));
        append({{left, at_left}, {left, piece.high.y()}});
    }
}

void ClippedPiece::append(const RisingPiece& piece) {
    if (piece.low.y() < piece.high.y()) {
        pieces_[count_++] = piece;
    }
}

}  // namespace foam::texgen
