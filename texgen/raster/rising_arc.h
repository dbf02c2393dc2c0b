#pragma once

#include "core/geometry/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// To the nearest, ties up; |x| < 2^30.
inline std::int32_t rounded(double x) {
    constexpr std::int32_t kBias = 1 << 30;  // makes the sum positive, where truncation is floor
    return static_cast<std::int32_t>(x + (kBias + 0.5)) - kBias;
}

/// An arc that rises from the origin, and goes neither back in x nor in y.
///
/// From the middle of its chord d, an arc of half angle a runs through the q where
///     cos a (d x q) + sin a (d² / 4 - q²) = 0,
/// which is quadratic in x for a given y, and in y for a given x. The root that is on the arc has a
/// form in which nothing cancels.
class RisingArc {
  public:
    /// `sine` is that of half the angle by which it turns left. Precondition: head.y() > 0.
    RisingArc(const Vec2& head, double sine)
        : head_(head), sine_(sine), to_left_(head.x() < 0.0), half_curvature_(sine / head.norm()) {
        const double cosine = std::sqrt(1.0 - sine * sine);
        bulge_ = 0.25 * sine * head.squaredNorm();
        across_ = cosine * head.x();
        up_ = cosine * head.y();
    }

    /// Where it crosses a height, 0 <= y <= that of its head.
    double x_at(double y) const {
        const double q = y - 0.5 * head_.y();
        const double c = bulge_ + q * (across_ - sine_ * q);
        const double squared = up_ * up_ + 4.0 * sine_ * c;
        const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
        const double x = 0.5 * head_.x() + 2.0 * c / (up_ + root);
        const double left = to_left_ ? head_.x() : 0.0;
        const double right = to_left_ ? 0.0 : head_.x();
        return x < left ? left : x > right ? right : x;
    }

    /// The same at y, y + step, ..., or x, x + step, ..., rounded to the nearest, ties up.
    void find_x(double y, double step, std::span<std::int32_t> xs) const;
    void find_y(double x, double step, std::span<std::int32_t> ys) const;

    /// Where it crosses an x between its ends.
    double y_at(double x) const {
        const double q = x - 0.5 * head_.x();
        const double c = bulge_ - q * (up_ + sine_ * q);
        const double squared = across_ * across_ + 4.0 * sine_ * c;
        const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
        const double y = 2.0 * c / (std::abs(across_) + root);
        return 0.5 * head_.y() + (to_left_ ? y : -y);
    }

    double half_curvature() const { return half_curvature_; }

  private:
    Vec2 head_;
    double sine_;
    bool to_left_;
    double half_curvature_;
    double bulge_;
    double across_;
    double up_;
};

}  // namespace foam::texgen
