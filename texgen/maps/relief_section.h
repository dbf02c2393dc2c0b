// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/simd/kernel.h"

#include <cmath>
#include <type_traits>
#include <variant>

namespace foam::texgen {

/// The shape of the relief across a film.
enum class ReliefProfile {
    Dome,   // every bubble is a dome between its films; a circular bubble is a spherical cap
    Ridge,  // films are rounded ridges on flat bubbles
    Wet,    // films are walls of liquid with fillets (Plateau borders) on both sides
};

// The sections of the three profiles. They have the same functions, which are described at
// ReliefSection. Loops that call these functions can be vectorized.

/// A spherical cap over a circle of radius 1. The cap meets the ground at the angle a. At the
/// distance r from the center of the circle, its height is sqrt(1/sin² a - r²) - cot a. The smooth
/// distance s at this point satisfies r² = 1 - 2 s.
struct DomeSection {
    double cotangent = 1.0;  // cot a

    double height(double smooth) const {
        return std::sqrt(cotangent * cotangent + 2.0 * smooth) - cotangent;
    }
    double slope(double smooth) const {
        return 1.0 / std::sqrt(cotangent * cotangent + 2.0 * smooth);
    }
    double distance(double smooth) const {
        return 1.0 - std::sqrt(max_value(1.0 - 2.0 * smooth, 0.0));
    }
    double smooth(double distance) const { return distance - 0.5 * distance * distance; }
};

/// A ridge has the height kHeight * (1 - s²)² at the smooth distance s, up to its foot at s = 1.
struct RidgeSection {
    static constexpr double kHeight = 0.5;  // height at the film

    double height(double smooth) const {
        const double inside = max_value(1.0 - smooth * smooth, 0.0);
        return kHeight * inside * inside;
    }
    double slope(double smooth) const {
        const double clamped = min_value(smooth, 1.0);
        return -4.0 * kHeight * clamped * (1.0 - clamped * clamped);
    }
    double distance(double smooth) const { return smooth; }
    double smooth(double distance) const { return distance; }
};

/// A fillet is a quarter of a circle of radius 1 that is tangent to the ground at the distance
/// x = 1 from the film. The two fillets on both sides of a film would meet in an infinitely steep
/// edge. Up to the distance kCrest from the film, a parabola replaces them.
struct WetSection {
    static constexpr double kCrest = 0.1;

    double height(double smooth) const {
        const double outside = min_value(max_value(smooth, kCrest), 1.0);
        const double inside = min_value(smooth, kCrest);
        return fillet_height(outside) +
               0.5 * fillet_slope(kCrest) * (inside * inside - kCrest * kCrest) / kCrest;
    }
    double slope(double smooth) const {
        return fillet_slope(min_value(max_value(smooth, kCrest), 1.0)) *
               min_value(smooth / kCrest, 1.0);
    }
    double distance(double smooth) const { return smooth; }
    double smooth(double distance) const { return distance; }

  private:
    // Precondition: 0 < x <= 1.
    static double fillet_height(double x) { return 1.0 - std::sqrt(x * (2.0 - x)); }
    static double fillet_slope(double x) { return (x - 1.0) / std::sqrt(x * (2.0 - x)); }
};

/// Returns the height of a section at the position x on a straight line across the film. The
/// position of the film is 0; positions on one side of it are negative. For domes, x = 1 is the
/// middle of the bubble. Beyond its middle a dome descends to the next film, so domes repeat with
/// the period 2.
template <class Section>
double height_along(const Section& section, double x) {
    const double from_film =
        std::is_same_v<Section, DomeSection> ? x - 2.0 * std::rint(0.5 * x) : x;
    return section.height(section.smooth(std::abs(from_film)));
}

/// A cross-section of the relief perpendicular to a film, symmetric about the film. The unit of
/// length is, for domes, the radius of a circle with the area of the bubble, and for other profiles
/// ReliefOptions::width. Heights depend on the smooth distance s from films (distance_field.h);
/// they do not include the factor ReliefOptions::strength. For domes, s = x - x²/2 at the distance
/// x from the film, as in a circle of radius 1. For other profiles, s itself is taken as the
/// distance x from the film, so that `distance` and `smooth` return their argument.
class ReliefSection {
  public:
    /// `angle` is the slope angle of domes at films, in radians, between 0 and pi / 2.
    ReliefSection(ReliefProfile profile, double angle);

    /// Returns function(section), where `section` is a DomeSection, a RidgeSection or a WetSection.
    template <class Function>
    auto visit(const Function& function) const {
        return std::visit(function, section_);
    }

    /// Return the height at a smooth distance, and its derivative with respect to the smooth
    /// distance. Precondition: the distance is not negative. For ridges and wet films it may be
    /// infinite, for example around a patch whose last bubble has vanished.
    double height(double smooth) const;
    double slope(double smooth) const;

    /// Convert a smooth distance to the distance x from the film, and back. The middle of a dome is
    /// at x = 1, which is the largest result of `distance` for domes.
    double distance(double smooth) const;
    double smooth(double distance) const;

    /// Returns the largest distance from the film that matters for the visible sky, in the
    /// section's unit. For domes, this is the distance of the middle of the dome. For ridges and
    /// wet films, it is the distance beyond which they hide practically no part of the sky.
    double reach() const { return is_dome() ? 1.0 : kSkyReach; }
    static constexpr double kSkyReach = 4.0;  // reach() of all profiles but domes

    bool is_dome() const { return std::holds_alternative<DomeSection>(section_); }

  private:
    std::variant<DomeSection, RidgeSection, WetSection> section_;
};

}  // namespace foam::texgen
