#pragma once

#include "core/geometry/vec2.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace foam::texgen {

/// Rounds to the nearest, ties up. Precondition: |x| < 2^30.
inline std::int32_t rounded(double x) {
    constexpr std::int32_t kBias = 1 << 30;  // makes the sum positive, where truncation is floor
    return static_cast<std::int32_t>(x + (kBias + 0.5)) - kBias;
}

/// Rounds to the nearest, ties to even. Precondition: |x| < 2^22.
inline std::int32_t rounded(float x) {
    constexpr float kWhole = 0x1.8p23F;  // beside which floats are whole numbers
    return std::bit_cast<std::int32_t>(x + kWhole) - std::bit_cast<std::int32_t>(kWhole);
}

/// An arc that rises from the origin, and goes neither back in x nor in y.
///
/// From the middle of its chord d, an arc of half angle a runs through the q where
///     cos a (d x q) + sin a (d² / 4 - q²) = 0,
/// which is quadratic in x for a given y, and in y for a given x. The root that is on the arc has a
/// form in which nothing cancels.
template <class Real>
class RisingArcOf {
  public:
    RisingArcOf() = default;

    /// `sine` is that of half the angle by which it turns left. Precondition: head.y() > 0.
    RisingArcOf(const Vec2& head, double sine)
        : half_x_(static_cast<Real>(0.5 * head.x())),
          half_y_(static_cast<Real>(0.5 * head.y())),
          sine_(static_cast<Real>(sine)),
          bulge_(static_cast<Real>(0.25 * sine * head.squaredNorm())),
          down_(head.x() < 0.0 ? Real(1) : Real(-1)) {
        const double cosine = std::sqrt(1.0 - sine * sine);
        across_ = static_cast<Real>(cosine * head.x());
        up_ = static_cast<Real>(cosine * head.y());
    }

    /// Where it crosses a height, 0 <= y <= that of its head.
    Real x_at(Real y) const {
        const Real q = y - half_y_;
        const Real c = bulge_ + q * (across_ - sine_ * q);
        const Real x = Real(2) * c / (up_ + root(up_ * up_ + Real(4) * sine_ * c));
        return half_x_ + within(x, std::abs(half_x_));
    }

    /// Where it crosses an x between its ends.
    Real y_at(Real x) const {
        const Real q = x - half_x_;
        const Real c = bulge_ - q * (up_ + sine_ * q);
        const Real y =
            Real(2) * c / (std::abs(across_) + root(across_ * across_ + Real(4) * sine_ * c));
        return half_y_ + within(down_ * y, half_y_);
    }

  private:
    static Real root(Real squared) { return std::sqrt(squared > Real(0) ? squared : Real(0)); }
    // The lower limit, too, if it is no number.
    static Real within(Real value, Real limit) {
        const Real raised = value > -limit ? value : -limit;
        return raised < limit ? raised : limit;
    }

    Real half_x_ = 0;
    Real half_y_ = 0;
    Real sine_ = 0;
    Real bulge_ = 0;
    Real across_ = 0;
    Real up_ = 0;
    Real down_ = 0;  // the sign of y - y of the middle, of what lies on the right of the chord
};

using RisingArc = RisingArcOf<double>;

}  // namespace foam::texgen
