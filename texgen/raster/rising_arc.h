#pragma once

#include "core/geometry/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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
    RisingArc() = default;

    /// `sine` is that of half the angle by which it turns left. Precondition: head.y() > 0.
    RisingArc(const Vec2& head, double sine)
        : head_(head), sine_(sine), half_curvature_(sine / head.norm()) {
        const double cosine = std::sqrt(1.0 - sine * sine);
        bulge_ = 0.25 * sine * head.squaredNorm();
        across_ = cosine * head.x();
        up_ = cosine * head.y();
        left_ = std::min(head.x(), 0.0);
        right_ = std::max(head.x(), 0.0);
        down_ = head.x() < 0.0 ? 1.0 : -1.0;
    }

    /// Where it crosses a height, 0 <= y <= that of its head.
    double x_at(double y) const {
        const double q = y - 0.5 * head_.y();
        const double c = bulge_ + q * (across_ - sine_ * q);
        const double squared = up_ * up_ + 4.0 * sine_ * c;
        const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
        const double x = 0.5 * head_.x() + 2.0 * c / (up_ + root);
        return within(x, left_, right_);
    }

    /// Where it crosses an x between its ends.
    double y_at(double x) const {
        const double q = x - 0.5 * head_.x();
        const double c = bulge_ - q * (up_ + sine_ * q);
        const double squared = across_ * across_ + 4.0 * sine_ * c;
        const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
        const double y = 2.0 * c / (std::abs(across_) + root);
        return within(0.5 * head_.y() + down_ * y, 0.0, head_.y());
    }

    double half_curvature() const { return half_curvature_; }

  private:
    // The lower one, too, if it is no number.
    static double within(double value, double lower, double upper) {
        const double raised = value > lower ? value : lower;
        return raised < upper ? raised : upper;
    }

    Vec2 head_{0.0, 0.0};
    double sine_ = 0.0;
    double half_curvature_ = 0.0;
    double bulge_ = 0.0;
    double across_ = 0.0;
    double up_ = 0.0;
    double left_ = 0.0;  // it lies between these
    double right_ = 0.0;
    double down_ = 0.0;  // the sign of y - y of the middle, of what lies on the right of the chord
};

/// Where an arc crosses heights y, y + step, ..., or places x, x + step, ...; to the nearest, ties
/// up, and then moved by an offset and mirrored.
struct ArcCrossings {
    static constexpr std::size_t kLanes = 8;  // found at once

    RisingArc arc;
    double first = 0.0;
    double step = 0.0;
    std::int32_t offset = 0;
    std::int32_t sign = 1;  // or -1
    std::size_t count = 0;
    std::size_t place = 0;  // of the first among the results, with room for whole vectors

    /// The place for those of the next arc.
    std::size_t end() const { return place + (count + kLanes - 1) / kLanes * kLanes; }
};

/// Of several arcs, none of which has to wait for the roots of another.
void find_xs(std::span<const ArcCrossings> arcs, std::int32_t* xs);
void find_ys(std::span<const ArcCrossings> arcs, std::int32_t* ys);

}  // namespace foam::texgen
