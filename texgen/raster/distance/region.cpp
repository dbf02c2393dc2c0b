// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/region.h"

#include "texgen/raster/coords/raster_grid.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kRounding = 2.0;  // margin for rounding errors, subpixels

// Returns an upper bound of the distance of an arc from its chord. This distance, the sagitta, is
// half the chord times the tangent of a quarter of the angle by which the arc turns. For wide arcs,
// the diameter of the circle is used instead. The sum of the absolute values of the two components
// of the chord is an upper bound of the chord's length.
double largest_sagitta(const OutlineArc& arc) {
    constexpr double kWideCosine = 0.2;  // largest cosine of the half angle of a wide arc
    const double length = (arc.to - arc.from).lpNorm<1>();
    const double sine = std::abs(arc.sine);
    return arc.cosine > kWideCosine ? 0.5 * length * sine / (1.0 + arc.cosine) : length / sine;
}

// Returns true if an arc turns by at most 120 degrees (DistanceArc::kMinCosine). The negated
// comparison is also true for NaN, so that the recursion of add_narrow_arcs ends.
bool is_narrow(const PixelArc& arc) {
    return !(arc.cosine < DistanceArc::kMinCosine);
}

}  // namespace

void Boundary::clear() {
    arcs_.clear();
    films_.clear();
    outline_.clear();
    loop_ = 0;
}

void Boundary::add_arc(const PixelArc& shape, const Vec2& tail) {
    if (!(shape.chord.squaredNorm() > kShortestChord * kShortestChord)) {
        return;
    }
    const Vec2 tangent = tail_tangent(shape);
    const bool is_first = arcs_.size() == loop_;
    if (is_first) {
        loop_tangent_ = tangent;
    }
    const DistanceArc arc{tail, shape, !is_first && cross(head_tangent_, tangent) < 0.0};
    if (films_.empty() && is_narrow(shape)) [[likely]] {
        arcs_.push_back(arc);
    } else {
        if (films_.empty()) {
            films_ = arcs_;
        }
        films_.push_back(arc);
        add_narrow_arcs(arc, arcs_);
    }
    head_tangent_ = head_tangent(shape);
}

void Boundary::close_loop() {
    if (arcs_.size() > loop_ && cross(head_tangent_, loop_tangent_) < 0.0) {
        arcs_[loop_].corner = true;
    }
    loop_ = arcs_.size();
}

// The head of each arc is the tail of another arc of its loop, so that heads are not needed.
Extent Boundary::extent() const {
    Extent box{outline_.front().from, outline_.front().from};
    double sagitta = 0.0;
    for (const OutlineArc& arc : outline_) {
        box.lowest = box.lowest.cwiseMin(arc.from);
        box.highest = box.highest.cwiseMax(arc.from);
        sagitta = std::max(sagitta, largest_sagitta(arc));
    }
    const Vec2 margin = Vec2::Constant(std::floor(sagitta + kRounding));
    return {box.lowest - margin, box.highest + margin};
}

// The middle of an arc that turns left is to the right of the middle of the chord. The distance
// between these two points, the sagitta, is half the chord times the tangent of half the half
// angle.
std::array<PixelArc, 2> halves(const PixelArc& arc) {
    const double cosine = std::sqrt(0.5 * (1.0 + arc.cosine));
    const double sine = 0.5 * arc.sine / cosine;
    const Vec2 half_chord = 0.5 * arc.chord;
    const Vec2 sagitta = -sine / cosine * turned_left(half_chord);
    return {PixelArc{half_chord + sagitta, cosine, sine},
            PixelArc{half_chord - sagitta, cosine, sine}};
}

void add_narrow_arcs(const DistanceArc& arc, std::vector<DistanceArc>& arcs) {
    if (is_narrow(arc.shape)) {
        arcs.push_back(arc);
        return;
    }
    const auto [first, second] = halves(arc.shape);
    add_narrow_arcs({arc.tail, first, arc.corner}, arcs);
    add_narrow_arcs({arc.tail + first.chord, second, false}, arcs);
}

}  // namespace foam::texgen
