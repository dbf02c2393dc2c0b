#include "texgen/raster/snapped_arc.h"

#include "texgen/raster/arcs/monotone.h"
#include "texgen/raster/arcs/rising_arc.h"

namespace foam::texgen {

// A horizontal tangent lies between those at its ends, or does not.
RisingPieces::RisingPieces(const SnappedArc& arc) {
    const SubpixelPoint chord = arc.head - arc.tail;
    const double along = arc.cosine * chord.y;
    const double across = arc.sine * chord.x;
    if (arc.cosine > 0.0 && std::abs(along) >= std::abs(across)) {
        append(arc.tail, arc.head, arc.cosine, arc.sine);
    } else if (chord.x != 0 || chord.y != 0) {
        split(arc);
    }
}

// From the lower end on, or from the left one, so that both sides have the same pieces.
void RisingPieces::split(const SnappedArc& side) {
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
        append(from, to, std::sqrt(1.0 - piece.sine * piece.sine), piece.sine);
        from = to;
    }
}

void RisingPieces::append(SubpixelPoint from, SubpixelPoint to, double cosine, double sine) {
    if (from.y < to.y) {
        pieces_[count_++] = {from, to, cosine, sine};
    } else if (to.y < from.y) {
        pieces_[count_++] = {to, from, cosine, -sine};
    }
}

}  // namespace foam::texgen
