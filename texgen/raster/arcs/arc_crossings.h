// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/raster/coords/fixed_point.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Returns x rounded to the nearest integer; ties are rounded up. Precondition: |x| < 2^30.
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
/// its tail and is monotone in x and in y. Coordinates are relative to the tail of the arc.
///
/// Let d be the chord of the arc, from tail to head, and alpha half the angle by which the arc
/// turns left. Let q be the vector from the middle of the chord to a point. The point is on the
/// circle of the arc if
///     cos alpha cross(d, q) + sin alpha (d² / 4 - q²) = 0.
/// If y is given, this is a quadratic equation for the x of q; if x is given, it is a quadratic
/// equation for the y of q. Let u be the unknown, and let the equation be a u² + b u = c, with the
/// sign of u chosen so that b >= 0. The root that is on the arc is computed as 2 c / (b + sqrt(b² +
/// 4 a c)), which avoids cancellation.
template <class Real>
class CrossingSolver {
  public:
    // The coefficients of the equation, with the symbols of the class comment.
    struct Coefficients {
        Real half_x = 0;  // (half_x, half_y) = d / 2
        Real half_y = 0;
        Real sine = 0;    // sin alpha
        Real bulge = 0;   // sin alpha d² / 4
        Real across = 0;  // (across, up) = cos alpha d
        Real up = 0;
    };

    CrossingSolver() = default;
    explicit CrossingSolver(const Coefficients& c) : c_(c) {}

    /// Create a solver for the arc from the origin to `head`, or to (x, y). `cosine` and `sine` are
    /// the cosine and the sine of half the angle by which the arc turns left; without `cosine`, the
    /// cosine is assumed to be positive. Precondition: head.y() > 0, or y > 0.
    CrossingSolver(const Vec2& head, double sine)
        : CrossingSolver(head, std::sqrt(1.0 - sine * sine), sine) {}
    CrossingSolver(const Vec2& head, double cosine, double sine)
        : CrossingSolver(head.x(), head.y(), cosine, sine) {}
    CrossingSolver(double x, double y, double cosine, double sine)
        : c_{static_cast<Real>(0.5 * x),
             static_cast<Real>(0.5 * y),
             static_cast<Real>(sine),
             static_cast<Real>(0.25 * sine * (x * x + y * y)),
             static_cast<Real>(cosine * x),
             static_cast<Real>(cosine * y)} {}

    const Coefficients& coefficients() const { return c_; }

    /// Returns the x at which the arc crosses the height y, clamped to the range between the x of
    /// the tail and the x of the head. Precondition: 0 <= y <= head.y().
    Real x_at(Real y) const { return c_.half_x + clamped(from_middle(y), std::abs(c_.half_x)); }

    /// Returns the x at which the arc crosses the height y, not clamped. The arc need not be
    /// monotone in x. Precondition: 0 <= y <= head.y().
    Real unbounded_x_at(Real y) const { return c_.half_x + from_middle(y); }

    /// Returns the y at which the arc crosses a vertical line, clamped to the range between the y
    /// of the tail and the y of the head. An arc that turns left bulges to the right of its chord.
    /// The right side of the chord is its lower side if head.x() >= 0, and otherwise its upper
    /// side. This determines the sign of the root. Precondition: x is between 0 and head.x().
    Real y_at(Real x) const {
        const Real q = x - c_.half_x;
        const Real c = c_.bulge - q * (c_.up + c_.sine * q);
        const Real y = Real(2) * c /
                       (std::abs(c_.across) + root(c_.across * c_.across + Real(4) * c_.sine * c));
        return c_.half_y + clamped(c_.half_x < Real(0) ? y : -y, c_.half_y);
    }

  private:
    // Returns the x at which the arc crosses the height y, relative to the middle of the chord.
    Real from_middle(Real y) const {
        const Real q = y - c_.half_y;
        const Real c = c_.bulge + q * (c_.across - c_.sine * q);
        return Real(2) * c / (c_.up + root(c_.up * c_.up + Real(4) * c_.sine * c));
    }
    // Returns the square root of a number, or 0 if rounding made the number negative.
    static Real root(Real squared) { return std::sqrt(squared > Real(0) ? squared : Real(0)); }
    // Clamps a value to [-limit, limit]. NaN becomes the lower limit.
    static Real clamped(Real value, Real limit) {
        const Real raised = value > -limit ? value : -limit;
        return raised < limit ? raised : limit;
    }

    Coefficients c_;
};

/// A rising arc, in subpixels, whose crossings with horizontal and vertical lines are rounded to
/// the nearest subpixel. If the arc is at most 256 pixels wide and high, its crossings are computed
/// in floats, with errors of up to 1/10 subpixel before rounding. Otherwise they are computed in
/// doubles.
class RoundedCrossings {
  public:
    RoundedCrossings() = default;
    /// Creates the arc from the origin to `head`. `sine` is as in CrossingSolver.
    RoundedCrossings(SubpixelPoint head, double sine)
        : head_(head.x, head.y), sine_(sine), in_floats_(head_, sine_) {}

    /// Returns true if crossings are computed in floats.
    bool is_short() const { return std::abs(head_.x()) <= kLongest && head_.y() <= kLongest; }
    const CrossingSolver<float>& in_floats() const { return in_floats_; }
    CrossingSolver<double> in_doubles() const { return {head_, sine_}; }

    /// Returns the x at which the arc crosses the height y. Precondition: 0 <= y <= head.y.
    std::int32_t x_at(std::int32_t y) const {
        return is_short() ? rounded(in_floats().x_at(static_cast<float>(y)))
                          : rounded(in_doubles().x_at(y));
    }

  private:
    static constexpr double kLongest = 256 * kSubpixel;  // largest width and height of short arcs

    Vec2 head_{0.0, 1.0};
    double sine_ = 0.0;
    CrossingSolver<float> in_floats_;
};

/// A query for `count` crossings of an arc with horizontal or vertical lines. Relative to the tail
/// of the arc, the lines are at `first`, first + step, first + 2 step, and so on. Each result is
/// sign * (offset + crossing), where `crossing` is relative to the tail, too. All coordinates are
/// in subpixels.
struct ArcCrossings {
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

/// Compute the crossings of several arcs. find_xs stores the x of crossings with horizontal lines,
/// find_ys the y of crossings with vertical lines. Result k of a query is stored at the index
/// position + k. All arcs are processed in one loop, so that the processor computes square roots of
/// different arcs at the same time. Precondition: the array has room for arcs.back().end() results.
void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs);
void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys);

}  // namespace foam::texgen
