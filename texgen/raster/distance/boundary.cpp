// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/boundary.h"

#include "texgen/raster/simd/kernel.h"

#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kRounding = 2.0;  // margin for rounding errors, subpixels

// The bounds of an outline, in subpixels.
struct Bounds {
    double left, right, bottom, top;  // bounds of the ends of arcs
    double beyond;                    // upper bound of the distance of any arc from its chord
};

// Extends the bounds by eight arcs. The largest distance of an arc from its chord is its sagitta:
// half the chord times the tangent of a quarter of the angle by which the arc turns. For wide arcs,
// the diameter of the circle is used as an upper bound instead. The sum of the absolute values of
// the two components of the chord is an upper bound of the chord's length. Heads are not needed,
// because each head in a closed loop is the tail of the next arc.
[[gnu::always_inline]] inline void extend(const Boundary::Outline& arcs, Bounds& bounds) {
    constexpr double kMinCosine = 0.2;  // wider arcs use the diameter
    Bounds b = bounds;
    for (std::size_t k = 0; k < ArcLanes::kLanes; ++k) {
        const double x = arcs.from_x[k];
        const double y = arcs.from_y[k];
        const double length = std::abs(arcs.to_x[k] - x) + std::abs(arcs.to_y[k] - y);
        const double sine = std::abs(arcs.sine[k]);
        const double cosine = arcs.cosine[k];
        const double sagitta = 0.5 * length * sine / (1.0 + cosine);
        const double beyond = cosine > kMinCosine ? sagitta : length / sine;
        b.left = min_value(x, b.left);
        b.right = max_value(x, b.right);
        b.bottom = min_value(y, b.bottom);
        b.top = max_value(y, b.top);
        b.beyond = max_value(beyond, b.beyond);
    }
    bounds = b;
}

}  // namespace

void Boundary::clear() {
    arcs_.clear();
    has_wide_ = false;
    loop_ = 0;
    edges_ = 0;
}

// Adds an arc to a boundary that has wide arcs, that is, arcs that are stored as halves in arcs_.
// `shape` may be the first wide arc.
void Boundary::add_wide(const PixelArc& shape, const Vec2& tail, bool corner) {
    if (!has_wide_) {
        films_ = arcs_;
        has_wide_ = true;
    }
    films_.add(shape, tail, corner);
    add_halves(shape, tail, corner);
}

void Boundary::add_halves(const PixelArc& shape, const Vec2& tail, bool corner) {
    if (shape.cosine >= ArcLanes::kMinCosine) {
        arcs_.add(shape, tail, corner);
        return;
    }
    const auto [first, second] = halves(shape);
    add_halves(first, tail, corner);
    add_halves(second, tail + first.chord, false);
}

void Boundary::close_loop() {
    if (arcs_.size() > loop_ && cross(head_tangent_, loop_tangent_) < 0.0) {
        arcs_.set_corner(loop_);
    }
    loop_ = arcs_.size();
}

Extent Boundary::extent() const {
    return at_simd_level([arcs = outline()] {
        const double x = arcs[0].from_x[0];
        const double y = arcs[0].from_y[0];
        Bounds bounds{x, x, y, y, 0.0};
        for (const Outline& some : arcs) {
            extend(some, bounds);
        }
        const double margin = std::floor(bounds.beyond + kRounding);
        return Extent{{bounds.left - margin, bounds.bottom - margin},
                      {bounds.right + margin, bounds.top + margin}};
    });
}

// The middle of an arc that turns left is to the right of the middle of the chord. The distance of
// these two points, the sagitta, is half the chord times the tangent of half the half angle.
std::array<PixelArc, 2> halves(const PixelArc& arc) {
    const double cosine = std::sqrt(0.5 * (1.0 + arc.cosine));
    const double sine = 0.5 * arc.sine / cosine;
    const Vec2 half_chord = 0.5 * arc.chord;
    const Vec2 sagitta = -sine / cosine * turned_left(half_chord);
    return {PixelArc{half_chord + sagitta, cosine, sine},
            PixelArc{half_chord - sagitta, cosine, sine}};
}

}  // namespace foam::texgen
