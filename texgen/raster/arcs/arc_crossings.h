// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/raster/coords/fixed_point.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Returns x rounded to the nearest integer; ties are rounded up. Precondition: |x| <= 2^30 - 1.
inline std::int32_t rounded(double x) {
    constexpr std::int32_t kBias = 1 << 30;  // makes the sum positive, so that truncation is floor
    return static_cast<std::int32_t>(x + (kBias + 0.5)) - kBias;
}

/// Returns x rounded to the nearest integer; ties are rounded to even. Precondition: |x| < 2^22.
inline std::int32_t rounded(float x) {
    // Adding kWhole rounds x, because all floats from 2^23 to 2^24 are whole numbers. The bits of
    // successive floats in this range are successive integers.
    constexpr float kWhole = 0x1.8p23F;
    return std::bit_cast<std::int32_t>(x + kWhole) - std::bit_cast<std::int32_t>(kWhole);
}

/// Computes the points at which an arc crosses horizontal and vertical lines. The arc rises from
/// its tail and is monotone in y. All functions except unbounded_x_at require that it is also
/// monotone in x. Coordinates are relative to the tail of the arc.
///
/// Let d be the chord of the arc, from tail to head, and alpha half the angle by which the arc
/// turns left. Let q be the vector from the middle of the chord to a point. The point is on the
/// circle of the arc if
///     cos alpha cross(d, q) + sin alpha (d² / 4 - q²) = 0.
/// For a given y, this is a quadratic equation for the x of q. For a given x, it is a quadratic
/// equation for the y of q. Let u be the unknown. The equation has the form a u² + b u = c, where
/// the sign of u is chosen so that b >= 0. The root on the arc is computed by a formula that avoids
/// cancellation:
///     u = 2 c / (b + sqrt(b² + 4 a c)).
template <class Real>
class CrossingSolver {
  public:
    CrossingSolver() = default;
    /// Create a solver for the arc from the origin to `head`. `cosine` and `sine` are the cosine
    /// and the sine of half the angle by which the arc turns left. Without `cosine`, the cosine is
    /// assumed to be positive. Precondition: head.y() > 0.
    CrossingSolver(const Vec2& head, double sine)
        : CrossingSolver(head, std::sqrt(1.0 - sine * sine), sine) {}
    CrossingSolver(const Vec2& head, double cosine, double sine)
        : half_x_(static_cast<Real>(0.5 * head.x())),
          half_y_(static_cast<Real>(0.5 * head.y())),
          sine_(static_cast<Real>(sine)),
          bulge_(static_cast<Real>(0.25 * sine * head.squaredNorm())),
          across_(static_cast<Real>(cosine * head.x())),
          up_(static_cast<Real>(cosine * head.y())) {}

    /// Returns the x at which the arc crosses the height y, clamped to the range between the x of
    /// the tail and the x of the head. Precondition: 0 <= y <= head.y().
    Real x_at(Real y) const { return half_x_ + clamped(from_middle(y), std::abs(half_x_)); }

    /// Returns the x at which the arc crosses the height y, not clamped. The arc need not be
    /// monotone in x. Precondition: 0 <= y <= head.y().
    Real unbounded_x_at(Real y) const { return half_x_ + from_middle(y); }

    /// Returns the y at which the arc crosses a vertical line, clamped to the range between the y
    /// of the tail and the y of the head. An arc that turns left bulges to the right of its chord.
    /// The right side of the chord is its lower side if head.x() >= 0, and otherwise its upper
    /// side. This determines the sign of the root. Precondition: x is between 0 and head.x().
    Real y_at(Real x) const {
        const Real q = x - half_x_;
        const Real c = bulge_ - q * (up_ + sine_ * q);
        const Real y =
            Real(2) * c / (std::abs(across_) + root(across_ * across_ + Real(4) * sine_ * c));
        return half_y_ + clamped(half_x_ < Real(0) ? y : -y, half_y_);
    }

  private:
    // Returns the x at which the arc crosses the height y, relative to the middle of the chord.
    Real from_middle(Real y) const {
        const Real q = y - half_y_;
        const Real c = bulge_ + q * (across_ - sine_ * q);
        return Real(2) * c / (up_ + root(up_ * up_ + Real(4) * sine_ * c));
    }
    // Returns the square root of a number, or 0 if rounding made the number negative.
    static Real root(Real squared) { return std::sqrt(squared > Real(0) ? squared : Real(0)); }
    // Clamps a value to [-limit, limit]. NaN becomes the lower limit.
    static Real clamped(Real value, Real limit) {
        const Real raised = value > -limit ? value : -limit;
        return raised < limit ? raised : limit;
    }

    // The coefficients of the equation, with the symbols of the class comment.
    Real half_x_ = 0;  // (half_x_, half_y_) = d / 2
    Real half_y_ = 0;
    Real sine_ = 0;    // sin alpha
    Real bulge_ = 0;   // sin alpha d² / 4
    Real across_ = 0;  // (across_, up_) = cos alpha d
    Real up_ = 0;
};

/// A rising arc, in subpixels, whose crossings are rounded to the nearest subpixel. The crossings
/// of an arc that is at most 256 pixels wide and high are computed in floats. Before rounding, the
/// computed points are less than 1/10 subpixel away from the arc. Where the arc is nearly parallel
/// to the line that it crosses, the crossing itself can be off by more. The crossings of any other
/// arc are computed in doubles.
class RoundedCrossings {
  public:
    RoundedCrossings() = default;
    /// Creates the arc from the origin to `head`. `sine` is as in CrossingSolver.
    RoundedCrossings(SubpixelPoint head, double sine)
        : head_(head.x, head.y), sine_(sine), in_floats_(head_, sine_) {}

    /// Returns true if crossings are computed in floats.
    bool is_short() const {
        return std::abs(head_.x()) <= kMaxShortSide && head_.y() <= kMaxShortSide;
    }
    const CrossingSolver<float>& in_floats() const { return in_floats_; }
    CrossingSolver<double> in_doubles() const { return {head_, sine_}; }

    /// Returns the x at which the arc crosses the height y. Precondition: 0 <= y <= head.y.
    std::int32_t x_at(std::int32_t y) const {
        return is_short() ? rounded(in_floats().x_at(static_cast<float>(y)))
                          : rounded(in_doubles().x_at(y));
    }

  private:
    // The largest width and height of short arcs, in subpixels.
    static constexpr double kMaxShortSide = 256 * kSubpixel;

    Vec2 head_{0.0, 1.0};
    double sine_ = 0.0;
    CrossingSolver<float> in_floats_;
};

/// A query for `count` crossings of an arc with horizontal or vertical lines. Relative to the tail
/// of the arc, the lines are at `first`, first + step, first + 2 step, and so on. Each result is
/// sign * (offset + crossing), where `crossing` is relative to the tail, too. All coordinates are
/// in subpixels.
struct CrossingQuery {
    static constexpr std::size_t kLanes = 8;  // number of crossings that are computed at once

    RoundedCrossings arc;
    std::int32_t first = 0;
    std::int32_t step = 0;
    std::int32_t offset = 0;
    std::int32_t sign = 1;  // 1 or -1
    std::size_t count = 0;
    std::size_t position = 0;  // index of the first result of this query

    /// Returns the position for the results of the next query. The number of results of a query is
    /// rounded up to a multiple of kLanes; the excess results are meaningless.
    std::size_t end() const { return position + (count + kLanes - 1) / kLanes * kLanes; }
};

/// Compute the crossings of several arcs: find_xs computes the x of crossings with horizontal
/// lines, and find_ys computes the y of crossings with vertical lines. Result k of a query is
/// stored at the index position + k. Precondition: the array has room for queries.back().end()
/// results.
void find_xs(std::span<const CrossingQuery> queries, std::int32_t* xs);
void find_ys(std::span<const CrossingQuery> queries, std::int32_t* ys);

}  // namespace foam::texgen
