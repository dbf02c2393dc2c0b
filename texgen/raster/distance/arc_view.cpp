// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/arc_view.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Let c be the length of the chord, a the half angle, and q the position of the point relative to
// the middle of the chord. Two functions are 0 at both ends of the chord:
// - e = c/4 - q²/c is 0 on the circle that has the chord as its diameter.
// - h is the signed distance of q from the line of the chord, positive on its left.
// A rotation by the half angle combines them into two other functions. Both have slope 1 where they
// are 0:
// - f = e sin a + h cos a is 0 on the circle of the arc, and positive on the left of the arc.
// - t = e cos a - h sin a is 0 on the circle that crosses the arc's circle at right angles at
//   both ends. It is positive on the arc.
//
// The distance to the circle of the arc is 2 |f| / (1 + |grad f|). Proof: let R be the radius, and
// r the distance from the center. Then |f| = |R² - r²| / 2R and |grad f| = r / R. The formula is
// our own. The distance |f| / |grad f| of G. Taubin ("Estimation of planar curves, surfaces, and
// nonplanar space curves defined by implicit equations", 1991) is its first-order approximation.
//
// For a point beyond an end of the arc, the distance from the normal at this end is a lower bound
// of the distance from the arc. This holds because arcs turn by less than 180 degrees
// (DistanceArc::kMinCosine).

namespace foam::texgen {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

// Computes the results for the eight arcs of a block. The comment at the top of this file explains
// the functions and their symbols.
[[gnu::always_inline]] inline void ArcView::evaluate(double x,
                                                     double y,
                                                     const ArcBlock& arcs,
                                                     Block& b) {
    const double far = kFar;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const double chord_x = arcs.chord_x[k];
        const double chord_y = arcs.chord_y[k];
        const double cosine = arcs.cosine[k];
        const double sine = arcs.sine[k];
        const double chord = std::sqrt(chord_x * chord_x + chord_y * chord_y);
        const double inverse_chord = 1.0 / chord;
        const double direction_x = chord_x * inverse_chord;
        const double direction_y = chord_y * inverse_chord;
        const double qx = x - (arcs.tail_x[k] + 0.5 * chord_x);
        const double qy = y - (arcs.tail_y[k] + 0.5 * chord_y);
        const double forward = qx * direction_x + qy * direction_y;
        const double left = qy * direction_x - qx * direction_y;
        const double e = 0.25 * chord - (qx * qx + qy * qy) * inverse_chord;
        const double curvature = 2.0 * inverse_chord * sine;
        const double along_curvature = 2.0 * inverse_chord * cosine;
        // The mean of past_tail and before_head, which ArcFunctions (pixel_batch.h) explains.
        const double mean_of_both = 0.5 * chord * cosine - sine * left;
        const double twice_value = 2.0 * (sine * e + cosine * left);
        const double slope_x = -curvature * qx - cosine * direction_y;
        const double slope_y = -curvature * qy + cosine * direction_x;
        const double past_tail = mean_of_both + cosine * forward;
        const double before_head = mean_of_both - cosine * forward;
        b.twice_value[k] = static_cast<float>(twice_value);
        b.slope_x[k] = static_cast<float>(slope_x);
        b.slope_y[k] = static_cast<float>(slope_y);
        b.curvature[k] = static_cast<float>(curvature);
        b.tail[k] = static_cast<float>(past_tail);
        b.tail_x[k] = static_cast<float>(cosine * direction_x + sine * direction_y);
        b.tail_y[k] = static_cast<float>(cosine * direction_y - sine * direction_x);
        b.head[k] = static_cast<float>(before_head);
        b.head_x[k] = static_cast<float>(sine * direction_y - cosine * direction_x);
        b.head_y[k] = static_cast<float>(-sine * direction_x - cosine * direction_y);
        b.twice_along[k] = static_cast<float>(2.0 * (cosine * e - sine * left));
        b.along_x[k] = static_cast<float>(-along_curvature * qx + sine * direction_y);
        b.along_y[k] = static_cast<float>(-along_curvature * qy - sine * direction_x);
        b.along_curvature[k] = static_cast<float>(along_curvature);
        b.chord[k] = static_cast<float>(chord);
        const double slope = std::sqrt(slope_x * slope_x + slope_y * slope_y);
        const double distance = std::abs(twice_value) / (1.0 + slope);
        const double end = min_value(past_tail, before_head);
        b.facing[k] = end >= 0.0 ? distance : far;
        b.lower_bound[k] = max_value(distance, -end);
    }
}

// Copies the arcs to lanes, eight at a time. Lanes beyond the last arc get copies of it.
void ArcView::evaluate(std::span<const DistanceArc> arcs, const Vec2& point) {
    size_ = arcs.size();
    grow(blocks_, (size_ + kLanes - 1) / kLanes);
    at_simd_level([arcs, x = point.x(), y = point.y(), to = blocks_.data()] {
        ArcBlock lanes{};
        for (std::size_t first = 0; first < arcs.size(); first += kLanes) {
            for (std::size_t k = 0; k < kLanes; ++k) {
                const DistanceArc& arc = arcs[min_value(first + k, arcs.size() - 1)];
                lanes.tail_x[k] = arc.tail.x();
                lanes.tail_y[k] = arc.tail.y();
                lanes.chord_x[k] = arc.shape.chord.x();
                lanes.chord_y[k] = arc.shape.chord.y();
                lanes.cosine[k] = arc.shape.cosine;
                lanes.sine[k] = arc.shape.sine;
            }
            evaluate(x, y, lanes, to[first / kLanes]);
        }
    });
}

double ArcView::horizon(double reach) const {
    double nearest = kFar;
    for (std::size_t k = 0; k < size_; ++k) {
        nearest = std::min(nearest, blocks_[k / kLanes].facing[k % kLanes]);
    }
    return nearest + 2.0 * reach + PixelBatch::kMargin;
}

ArcFunctions ArcView::arc_functions(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    k %= kLanes;
    return {{b.twice_value[k], b.slope_x[k], b.slope_y[k], b.curvature[k]},
            {b.tail[k], b.tail_x[k], b.tail_y[k]},
            {b.head[k], b.head_x[k], b.head_y[k]}};
}

FilmFunctions ArcView::film_functions(std::size_t k) const {
    const Block& b = blocks_[k / kLanes];
    const FloatQuadratic across = arc_functions(k).across;
    k %= kLanes;
    return {
        across, {b.twice_along[k], b.along_x[k], b.along_y[k], b.along_curvature[k]}, b.chord[k]};
}

}  // namespace foam::texgen
