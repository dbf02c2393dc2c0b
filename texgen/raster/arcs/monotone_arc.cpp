// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/monotone_arc.h"

namespace foam::texgen {

void append_arc(const PixelArc& arc,
                SubpixelPoint tail,
                SubpixelPoint head,
                const ArcSides& sides,
                std::vector<MonotoneArc>& to) {
    const auto inner = [&](const Vec2& at) { return tail + to_subpixel(at); };
    for_each_piece(arc, tail, head, inner, [&](SubpixelPoint from, SubpixelPoint end, double sine) {
        append_piece(from, end, sine, sides, to);
    });
}

void append_piece(SubpixelPoint tail,
                  SubpixelPoint head,
                  double sine,
                  const ArcSides& sides,
                  std::vector<MonotoneArc>& to) {
    if (tail.y < head.y) {
        to.push_back({tail, head, sine, sides});
    } else if (head.y < tail.y) {
        to.push_back({head, tail, -sine, reversed(sides)});
    }
}

// Computes the integral of 2 x dy along the chain. To keep rounding errors small, x is measured
// from the lower end of the first arc.
double twice_area(std::span<const MonotoneArc> chain, std::uint32_t bubble) {
    double area = 0.0;
    for (const MonotoneArc& arc : chain) {
        const SubpixelPoint chord = arc.high - arc.low;
        const double dx = chord.x;
        const double dy = chord.y;
        const double x = arc.low.x + arc.high.x - 2 * chain.front().low.x;
        const double part = x * dy + twice_segment(dx * dx + dy * dy, arc.sine);
        area += arc.sides.left == bubble ? part : -part;
    }
    return area;
}

}  // namespace foam::texgen
