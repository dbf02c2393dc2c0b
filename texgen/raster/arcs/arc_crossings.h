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

/// Rounds to the nearest integer, ties up. Precondition: |x| < 2^30.
inline std::int32_t rounded(double x) {
    constexpr std::int32_t kBias = 1 << 30;  // makes the sum positive, so that truncation is floor
    return static_cast<std::int32_t>(x + (kBias + 0.5)) - kBias;
}

/// Rounds to the nearest integer, ties to even. Precondition: |x| < 2^22.
inline std::int32_t rounded(float x) {
    constexpr float kWhole = 0x1.8p23F;  // floats of this size are whole numbers
    return std::bit_cast<std::int32_t>(x + kWhole) - std::bit_cast<std::int32_t>(kWhole);
}

/// Computes the points at which an arc crosses horizontal and vertical lines. The arc rises from
/// the origin and is monotone in x and in y. Coordinates are relative to the start of the arc.
///
/// Let d be the chord and a the half angle of the arc. A point at q from the middle of the chord is
/// on the circle of the arc if
///     cos a (d x q) + sin a (d² / 4 - q²) = 0,
/// which is quadratic in x for a given y, and in y for a given x. The root on the arc is computed
/// in the form 2 c / (b + sqrt(b² - 4 a c)), which avoids cancellation.
template <class Real>
class CrossingSolver {
  public:
    // The coefficients of the equation.
    struct Coefficients {
        Real half_x = 0;
        Real half_y = 0;
        Real sine = 0;
        Real bulge = 0;
        Real across = 0;
        Real up = 0;
    };

    CrossingSolver() = default;
    explicit CrossingSolver(const Coefficients& c) : c_(c) {}

    /// Creates a solver for the arc from the origin to `head`. `sine` and `cosine` are those of
    /// half the angle by which the arc turns left. Precondition: head.y() > 0.
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

    /// Returns the x at which the arc crosses the height y. Precondition: 0 <= y <= head.y().
    Real x_at(Real y) const { return c_.half_x + within(from_middle(y), std::abs(c_.half_x)); }

    /// Returns the same x, for an arc that may be non-monotone in x. The result is not clamped.
    Real unbounded_x_at(Real y) const { return c_.half_x + from_middle(y); }

    /// Returns the y at which the arc crosses an x between its ends. (The sign of the root depends
    /// on the direction: the right side of an arc that goes to the left is above its chord.)
    Real y_at(Real x) const {
        const Real q = x - c_.half_x;
        const Real c = c_.bulge - q * (c_.up + c_.sine * q);
        const Real y = Real(2) * c /
                       (std::abs(c_.across) + root(c_.across * c_.across + Real(4) * c_.sine * c));
        return c_.half_y + within(c_.half_x < Real(0) ? y : -y, c_.half_y);
    }

  private:
    Real from_middle(Real y) const {
        const Real q = y - c_.half_y;
        const Real c = c_.bulge + q * (c_.across - c_.sine * q);
        return Real(2) * c / (c_.up + root(c_.up * c_.up + Real(4) * c_.sine * c));
    }
    static Real root(Real squared) { return std::sqrt(squared > Real(0) ? squared : Real(0)); }
    // Clamps a value to [-limit, limit]. NaN becomes the lower limit.
    static Real within(Real value, Real limit) {
        const Real raised = value > -limit ? value : -limit;
        return raised < limit ? raised : limit;
    }

    Coefficients c_;
};

/// Computes the crossings of a rising arc in subpixels, rounded to the nearest. Arcs of up to 256
/// pixels are computed in floats, with errors of up to 1/10 of a subpixel; longer arcs in doubles.
class RoundedCrossings {
  public:
    RoundedCrossings() = default;
    /// See CrossingSolver.
    RoundedCrossings(SubpixelPoint head, double sine)
        : head_(head.x, head.y), sine_(sine), in_floats_(head_, sine_) {}

    bool is_short() const { return std::abs(head_.x()) <= kLongest && head_.y() <= kLongest; }
    const CrossingSolver<float>& in_floats() const { return in_floats_; }
    CrossingSolver<double> in_doubles() const { return {head_, sine_}; }

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

/// A query for `count` crossings of an arc with horizontal or vertical lines. The lines have the
/// coordinates first, first + step, first + 2 step, and so on. Each result is sign * (offset +
/// crossing).
struct ArcCrossings {
    static constexpr std::size_t kLanes = 8;  // computed at once

    RoundedCrossings arc;
    std::int32_t first = 0;
    std::int32_t step = 0;
    std::int32_t offset = 0;
    std::int32_t sign = 1;  // 1 or -1
    std::size_t count = 0;
    std::size_t position = 0;  // index of the first result; results are padded to whole vectors

    /// Returns the position for the results of the next query.
    std::size_t end() const { return position + (count + kLanes - 1) / kLanes * kLanes; }
};

/// Compute the crossings of several arcs with horizontal lines (find_xs) or vertical lines
/// (find_ys). The square roots of different arcs overlap.
void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs);
void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys);

}  // namespace foam::texgen
