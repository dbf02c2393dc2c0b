// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_section.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kRidgeHeight = 0.5;  // in the section's unit of length (see ReliefSection)
// The two fillets on both sides of a film would meet in an infinitely steep edge. Up to this
// distance from the film, in the section's unit, a parabola replaces the fillets.
constexpr double kCrest = 0.1;

// Return the height and the slope of a fillet: a quarter of a circle of radius 1 that is tangent to
// the ground at x = 1. Precondition: 0 < x <= 1.
double fillet_height(double x) {
    return 1.0 - std::sqrt(x * (2.0 - x));
}

double fillet_slope(double x) {
    return (x - 1.0) / std::sqrt(x * (2.0 - x));
}

}  // namespace

ReliefSection::ReliefSection(ReliefProfile profile, double angle)
    : profile_(profile), cotangent_(1.0 / ieee::tan(angle)) {}

// A spherical cap over a circle of radius 1 that meets the ground at an angle a has the height
// sqrt(1/sin² a - r²) - cot a at the distance r from the center of the circle. The smooth distance
// s at this point satisfies r² = 1 - 2 s.
double ReliefSection::height(double smooth) const {
    switch (profile_) {
        case ReliefProfile::Dome:
            return std::sqrt(cotangent_ * cotangent_ + 2.0 * smooth) - cotangent_;
        case ReliefProfile::Ridge: {
            const double inside = std::max(1.0 - smooth * smooth, 0.0);
            return kRidgeHeight * inside * inside;
        }
        default: {
            const double outside = std::clamp(smooth, kCrest, 1.0);
            const double inside = std::min(smooth, kCrest);
            return fillet_height(outside) +
                   0.5 * fillet_slope(kCrest) * (inside * inside - kCrest * kCrest) / kCrest;
        }
    }
}

double ReliefSection::slope(double smooth) const {
    switch (profile_) {
        case ReliefProfile::Dome:
            return 1.0 / std::sqrt(cotangent_ * cotangent_ + 2.0 * smooth);
        case ReliefProfile::Ridge: {
            const double clamped = std::min(smooth, 1.0);
            return -4.0 * kRidgeHeight * clamped * (1.0 - clamped * clamped);
        }
        default:
            return fillet_slope(std::clamp(smooth, kCrest, 1.0)) * std::min(smooth / kCrest, 1.0);
    }
}

double ReliefSection::distance(double smooth) const {
    const bool dome = profile_ == ReliefProfile::Dome;
    return dome ? 1.0 - std::sqrt(std::max(1.0 - 2.0 * smooth, 0.0)) : smooth;
}

double ReliefSection::smooth(double distance) const {
    return profile_ == ReliefProfile::Dome ? distance - 0.5 * distance * distance : distance;
}

double ReliefSection::height_along(double x) const {
    // Beyond its middle a dome descends to the next film, so domes repeat with the period 2.
    const bool dome = profile_ == ReliefProfile::Dome;
    return height(smooth(std::abs(dome ? std::remainder(x, 2.0) : x)));
}

}  // namespace foam::texgen
