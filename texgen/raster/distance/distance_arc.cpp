#include "texgen/raster/distance/distance_arc.h"

#include "texgen/raster/coords/fixed_point.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kRounding = 2.0;  // subpixels; more than both ends of a side move when rounded

// Returns a bound of the distance between an arc and its chord in pixels: the sagitta, half the
// chord times the tangent of a quarter of the turn. Wide arcs have a diameter instead. The length
// of the chord is bounded by the sum of its components.
double reach_beyond_chord(const PixelArc& arc) {
    constexpr double kLeastCosine = 0.2;  // of an arc whose sagitta is computed
    const double length = std::abs(arc.chord.x()) + std::abs(arc.chord.y());
    const double sine = std::abs(arc.sine);
    return arc.cosine > kLeastCosine ? 0.5 * length * sine / (1.0 + arc.cosine) : length / sine;
}

}  // namespace

void Boundary::clear() {
    sides.clear();
    loop_ends.clear();
    edges.clear();
}

std::span<const DistanceArc> Boundary::loop(std::size_t k) const {
    const std::size_t begin = k == 0 ? 0 : loop_ends[k - 1];
    return std::span(sides).subspan(begin, loop_ends[k] - begin);
}

Extent extent_of(const Boundary& boundary) {
    const Vec2& first = boundary.sides.front().from;
    Extent extent{first, first};
    double beyond = 0.0;
    for (const DistanceArc& side : boundary.sides) {
        extent.lowest = extent.lowest.cwiseMin(side.from);
        extent.highest = extent.highest.cwiseMax(side.from);
        beyond = std::max(beyond, reach_beyond_chord(side.shape));
    }
    const Vec2 margin = Vec2::Constant(std::floor(beyond * kSubpixel + kRounding));
    return {extent.lowest - margin, extent.highest + margin};
}

// The middle of the arc is the sagitta, c/2 tan(half of the half angle), to the right of the chord.
std::array<PixelArc, 2> halves(const PixelArc& arc) {
    const double cosine = std::sqrt(0.5 * (1.0 + arc.cosine));
    const double sine = 0.5 * arc.sine / cosine;
    const Vec2 half_chord = 0.5 * arc.chord;
    const Vec2 sagitta = -sine / cosine * turned_left(half_chord);
    return {PixelArc{half_chord + sagitta, cosine, sine},
            PixelArc{half_chord - sagitta, cosine, sine}};
}

}  // namespace foam::texgen
