// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/reflections.h"

#include "core/geometry/elementary.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/degree.h"
#include "texgen/maps/smooth_step.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kSharpest = 0.01;     // smallest softness of an edge; it looks sharp
constexpr double kSecondWindow = 0.4;  // brightness of a window relative to the one before it
// Half the width of the transition from the sky to the ground, as the sine of an elevation.
constexpr double kHaze = 0.12;

// Returns 1 if x is at most 1 - softness, 0 if x is at least 1 + softness, and a smooth transition
// in between.
double soft_edge(double x, double softness) {
    return smooth_step(std::clamp((1.0 + softness - x) / (2.0 * softness), 0.0, 1.0));
}

}  // namespace

Keys<ReflectionOptions> reflection_keys() {
    using Options = ReflectionOptions;
    return {key("windows",
                Integers{0, 2},
                "number of windows that every bubble reflects: the first in the direction of the "
                "light, the second, fainter one at the opposite azimuth",
                &Options::windows)
                .in("windows"),
            key("window_size",
                Reals{1.0, 120.0},
                "width and height of a window, degrees",
                &Options::window_size)
                .in("degrees")
                .unused_with("lit.windows", {"0"}),
            key("window_softness",
                kFractions,
                "width of the soft border of a window, as a fraction of its size",
                &Options::window_softness)
                .in("fraction of the size")
                .unused_with("lit.windows", {"0"}),
            key("window_brightness",
                Reals{0.0, 1000.0},
                "brightness of the reflection of the first window",
                &Options::window_brightness)
                .unused_with("lit.windows", {"0"}),
            key("horizon",
                Reals{0.0, 1000.0},
                "factor on the brightness of the reflected sky, which is brightest near the "
                "horizon and appears as a ring in every dome that is steep enough",
                &Options::horizon)};
}

Direction direction_of(double azimuth, double elevation) {
    return {ieee::cos(elevation * kDegree) * ieee::cos(azimuth * kDegree),
            ieee::cos(elevation * kDegree) * ieee::sin(azimuth * kDegree),
            ieee::sin(elevation * kDegree)};
}

Window::Window(double azimuth, double elevation, double degrees, double softness)
    : middle_(direction_of(azimuth, elevation)),
      across_(direction_of(azimuth + 90.0, 0.0)),
      upward_(middle_.cross(across_)),
      half_size_(ieee::tan(0.5 * degrees * kDegree)),
      softness_(std::max(softness, kSharpest)) {}

// Projects the direction to the plane of the window.
double Window::at(const Direction& direction) const {
    const double distance = direction.dot(middle_);
    if (!(distance > 0.0)) {
        return 0.0;
    }
    const double scale = 1.0 / (distance * half_size_);
    return soft_edge(std::abs(direction.dot(across_)) * scale, softness_) *
           soft_edge(std::abs(direction.dot(upward_)) * scale, softness_);
}

Reflections::Reflections(const ReflectionOptions& options, double azimuth, double elevation)
    : options_(options) {
    for (int k = 0; k < options.windows; ++k) {
        windows_.emplace_back(
            azimuth + 180.0 * k, elevation, options.window_size, options.window_softness);
    }
    flat_ = around(Direction::UnitZ());
}

double Reflections::brightness(const Direction& normal) const {
    const Direction mirrored = 2.0 * normal.z() * normal - Direction::UnitZ();
    return std::max(around(mirrored) - flat_, 0.0);
}

// Returns the brightness of the surroundings in a direction.
double Reflections::around(const Direction& direction) const {
    double sum = 0.0;
    double window_brightness = options_.window_brightness;
    for (const Window& window : windows_) {
        sum += window_brightness * window.at(direction);
        window_brightness *= kSecondWindow;
    }
    const double above = std::clamp(direction.z(), 0.0, 1.0);
    const double steep = 1.0 - above;  // the brightness of the sky is its fourth power
    const double sky = smooth_step(std::clamp(0.5 + 0.5 * direction.z() / kHaze, 0.0, 1.0));
    return sum + options_.horizon * sky * (steep * steep) * (steep * steep);
}

}  // namespace foam::texgen
