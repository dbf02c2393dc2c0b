#include "texgen/raster/row_crossings.h"

#include "texgen/raster/make_room.h"
#include "texgen/raster/monotone.h"
#include "texgen/raster/rising_arc.h"
#include "texgen/raster/vector_clones.h"

#include <cmath>

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = 4;  // crossings found at once

}  // namespace

// A horizontal tangent lies between those at its ends, or does not.
void RowCrossings::add(const SnappedArc& arc, const CellMask& mask) {
    const SubpixelPoint chord = arc.head - arc.tail;
    const double along = arc.cosine * chord.y;
    const double across = arc.sine * chord.x;
    if (arc.cosine > 0.0 && along >= std::abs(across)) {
        add_rising(arc, mask);
    } else if (arc.cosine > 0.0 && -along >= std::abs(across)) {
        add_rising({arc.head, arc.tail, arc.cosine, -arc.sine}, mask);
    } else if (chord.x != 0 || chord.y != 0) {
        add_pieces(arc, mask);
    }
}

void RowCrossings::add_rising(const SnappedArc& arc, const CellMask& mask) {
    const auto [begin, end] = mask.rows_between(arc.tail.y, arc.head.y);
    if (begin >= end) {
        return;
    }
    const auto rows = static_cast<std::size_t>(end - begin);
    const SubpixelPoint chord = arc.head - arc.tail;
    const double x = chord.x;
    const double y = chord.y;
    constexpr std::int32_t kMiddle = kSubpixel / 2;
    arcs_.push_back({0.5 * x,
                     0.5 * y,
                     arc.sine,
                     0.25 * arc.sine * (x * x + y * y),
                     arc.cosine * x,
                     arc.cosine * y,
                     static_cast<double>(begin * kSubpixel + kMiddle - arc.tail.y),
                     arc.tail.x,
                     begin,
                     count_,
                     rows});
    count_ += (rows + kLanes - 1) / kLanes * kLanes;
}

void RowCrossings::mark(CellMask& mask) {
    make_room(xs_, count_);
    find(arcs_, xs_.data());
    for (const Rising& arc : arcs_) {
        for (std::size_t k = 0; k < arc.count; ++k) {
            mask.cross(arc.row + static_cast<int>(k), arc.x + xs_[arc.first + k]);
        }
    }
    mask.close();
    arcs_.clear();
    count_ = 0;
}

// As RisingArc::x_at, of arcs that may go back in x. Rows beyond the arc's fill the last vector.
FOAMTEX_VECTOR_CLONES void RowCrossings::find(std::span<const Rising> arcs, std::int32_t* xs) {
    for (const Rising& a : arcs) {
        for (std::size_t from = 0; from < a.count; from += kLanes) {
            const double y = a.y + static_cast<double>(from) * kSubpixel - a.half_y;
            for (std::size_t k = 0; k < kLanes; ++k) {
                const double q = y + static_cast<double>(static_cast<int>(k)) * kSubpixel;
                const double c = a.bulge + q * (a.across - a.sine * q);
                const double squared = a.up * a.up + 4.0 * a.sine * c;
                const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
                xs[a.first + from + k] = rounded(a.half_x + 2.0 * c / (a.up + root));
            }
        }
    }
}

// From the lower end on, or from the left one, so that both sides have the same pieces.
void RowCrossings::add_pieces(const SnappedArc& side, const CellMask& mask) {
    const SubpixelPoint ahead = side.head - side.tail;
    const bool is_up = ahead.y > 0 || (ahead.y == 0 && ahead.x > 0);
    const SnappedArc arc = is_up ? side : SnappedArc{side.head, side.tail, side.cosine, -side.sine};
    const SubpixelPoint chord = arc.head - arc.tail;
    const MonotonePieces all({Vec2(chord.x, chord.y), arc.cosine, arc.sine});
    SubpixelPoint from = arc.tail;
    for (const MonotonePiece& piece : all.pieces()) {
        const bool is_last = &piece == &all.pieces().back();
        const SubpixelPoint to =
            is_last ? arc.head
                    : arc.tail + SubpixelPoint{rounded(piece.head.x()), rounded(piece.head.y())};
        const double cosine = std::sqrt(1.0 - piece.sine * piece.sine);
        if (from.y < to.y) {
            add_rising({from, to, cosine, piece.sine}, mask);
        } else {
            add_rising({to, from, cosine, -piece.sine}, mask);
        }
        from = to;
    }
}

}  // namespace foam::texgen
