// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <numbers>

namespace foam::texgen::test {

/// A cap of a sphere that meets the ground at an angle on a circle. The dome of a lone bubble is
/// one.
struct SphericalCap {
    double radius;                                   // of the circle
    double angle = 50.0 * std::numbers::pi / 180.0;  // as relief.angle is by default
    double sphere = radius / std::sin(angle);        // radius of the sphere

    /// Returns the height at a distance from the axis.
    double height(double r) const {
        return std::sqrt(sphere * sphere - r * r) - sphere * std::cos(angle);
    }
};

}  // namespace foam::texgen::test
