#include "texgen/raster/arc_batch.h"

#include "texgen/raster/arcs/monotone.h"

namespace foam::texgen {

void append_arc(const PixelArc& arc,
                SubpixelPoint tail,
                SubpixelPoint head,
                const ArcSides& sides,
                std::vector<CellArc>& to) {
    const MonotonePieces all(arc);
    const std::span<const MonotonePiece> pieces = all.pieces();
    SubpixelPoint from = tail;
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
        const SubpixelPoint end = tail + to_subpixel(pieces[k].head);
        append_piece(from, end, pieces[k].sine, sides, to);
        from = end;
    }
    append_piece(from, head, pieces.back().sine, sides, to);
}

// The integral of 2 x dy, with x from the first arc.
double twice_area(std::span<const CellArc> chain, std::uint32_t bubble) {
    double area = 0.0;
    for (const CellArc& arc : chain) {
        const SubpixelPoint chord = arc.high - arc.low;
        const double dx = chord.x;
        const double dy = chord.y;
        const double x = arc.low.x + arc.high.x - 2 * chain.front().low.x;
        const double part = x * dy + twice_segment(dx * dx + dy * dy, arc.sine);
        area += arc.left == bubble ? part : -part;
    }
    return area;
}

}  // namespace foam::texgen
