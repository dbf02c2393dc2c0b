// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/clip_arc.h"

#include "texgen/raster/arcs/arc_crossings.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// Returns the part of a piece between the heights `low` and `high`. Precondition: both are between
// the heights of the ends of the piece.
MonotonePiece part_between(const MonotonePiece& piece, double low, double high) {
    const CrossingSolver<double> arc(piece.head - piece.tail, piece.sine);
    const auto point_at = [&](double y) {
        return Vec2(piece.tail.x() + arc.x_at(y - piece.tail.y()), y);
    };
    MonotonePiece part{low > piece.tail.y() ? point_at(low) : piece.tail,
                       high < piece.head.y() ? point_at(high) : piece.head};
    const double half_curvature = piece.sine / (piece.head - piece.tail).norm();
    part.sine = half_curvature * (part.head - part.tail).norm();
    return part;
}

// Returns the height at which a piece crosses the vertical line at x. If the piece does not cross
// the line, returns the height of the end that is nearer to the line.
double height_at(const MonotonePiece& piece, double x) {
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

boost::container::static_vector<MonotonePiece, 2> clipped(const MonotonePiece& piece,
                                                          const Vec2& low,
                                                          const Vec2& high) {
    boost::container::static_vector<MonotonePiece, 2> pieces;
    const auto append = [&](const MonotonePiece& part) {
        if (part.tail.y() < part.head.y()) {
            pieces.push_back(part);
        }
    };
    const double bottom = std::max(piece.tail.y(), low.y());
    const double top = std::min(piece.head.y(), high.y());
    if (bottom >= top) {
        return pieces;
    }
    const MonotonePiece visible = part_between(piece, bottom, top);
    const double left = low.x();
    const double at_left = height_at(visible, left);
    const double at_right = height_at(visible, high.x());
    if (visible.tail.x() < visible.head.x()) {
        append({{left, bottom}, {left, at_left}});
        append(part_between(visible, at_left, at_right));
    } else {
        append(part_between(visible, at_right, at_left));
        append({{left, at_left}, {left, top}});
    }
    return pieces;
}

}  // namespace foam::texgen
