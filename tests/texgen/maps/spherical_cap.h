// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <numbers>

namespace foam::texgen::test {

/// A cap of a sphere that meets the ground at an angle along a circle, such as the dome of a lone
/// bubble.
struct SphericalCap {
    double radius;                                   // radius of the circle
    double angle = 50.0 * std::numbers::pi / 180.0;  // default of relief.angle, radians
    double sphere = radius / std::sin(angle);        // radius of the sphere

    /// Returns the height at the distance r from the axis.
    double height(double r) const {
        return std::sqrt(sphere * sphere - r * r) - sphere * std::cos(angle);
    }
};

}  // namespace foam::texgen::test
