// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/keys/key.h"
#include "texgen/maps/smooth_step.h"
#include "texgen/raster/simd/kernel.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace foam::texgen {

/// The options of the reflections in the map `lit`. Like a mirror, the surface reflects up to two
/// windows, and a sky that is brightest just above the horizon. The first window is in the
/// direction of the light. The second window has the same elevation and the opposite azimuth, and
/// is fainter, like the reflection from the back of a bubble.
struct ReflectionOptions {
    int windows = 0;                 // number of windows, from 0 to 2
    double window_size = 30.0;       // width and height of a window, degrees
    double window_softness = 0.4;    // width of the soft border of a window, as a fraction of
                                     // the size of the window
    double window_brightness = 1.0;  // brightness of the first window
    // Factor on the brightness of the sky. Haze halves the brightness at the horizon itself; the
    // largest brightness, slightly above the horizon, is about two thirds of this factor.
    double horizon = 0.0;
};

Keys<ReflectionOptions> reflection_keys();

/// A direction: a vector of length 1 with the components right, up, and toward the viewer.
using Direction = Eigen::Vector3d;

/// Returns the direction with the given azimuth and elevation in degrees (LightOptions).
Direction direction_of(double azimuth, double elevation);

/// A bright square window in a given direction. The surface reflects it.
class Window {
  public:
    Window() = default;
    /// `azimuth` and `elevation` give the direction of the window's middle, in degrees. `degrees`
    /// is the width of the window, and `softness` is ReflectionOptions::window_softness.
    Window(double azimuth, double elevation, double degrees, double softness);

    /// Returns the brightness in a direction, from 0 to 1. Loops that call this function can be
    /// vectorized.
    double at(const Direction& direction) const {
        // The direction is projected to the plane of the window at distance 1.
        const double distance = direction.dot(middle_);
        const double scale = 1.0 / (max_value(distance, kGrazing) * half_size_);
        const double inside = soft_edge(std::abs(direction.dot(across_)) * scale) *
                              soft_edge(std::abs(direction.dot(upward_)) * scale);
        return distance > 0.0 ? inside : 0.0;
    }

  private:
    // The lower bound of the divisor in `at`, a cosine of an angle to the middle of the window.
    static constexpr double kGrazing = 1e-100;

    // Returns 1 if x is at most 1 - softness, 0 if x is at least 1 + softness, and a smooth
    // transition in between.
    double soft_edge(double x) const {
        const double passed = (1.0 + softness_ - x) / (2.0 * softness_);
        return smooth_step(min_value(max_value(passed, 0.0), 1.0));
    }

    Direction middle_ = Direction::Zero();
    Direction across_ = Direction::Zero();
    Direction upward_ = Direction::Zero();
    double half_size_ = 1.0;  // half the width of the window, if it is at distance 1
    double softness_ = 1.0;
};

/// The surroundings that a mirror reflects (ReflectionOptions). The ground below the horizon is
/// black, with a soft transition to the sky.
class Reflections {
  public:
    /// `azimuth` and `elevation` give the direction of the light, in degrees.
    Reflections(const ReflectionOptions& options, double azimuth, double elevation);

    /// Returns true if nothing is reflected.
    bool are_none() const { return !has_windows_ && horizon_ == 0.0; }

    /// Returns how much brighter a mirror with the given normal looks than a horizontal mirror, to
    /// a viewer straight above it. The result is 0 if the mirror is not brighter. Loops that call
    /// this function can be vectorized.
    double brightness(const Direction& normal) const {
        const double twice = 2.0 * normal.z();
        return max_value(
            light_from({twice * normal.x(), twice * normal.y(), twice * normal.z() - 1.0}) - flat_,
            0.0);
    }

  private:
    // Half the width of the transition from the sky to the ground, as the sine of an elevation.
    static constexpr double kHaze = 0.12;
    static constexpr std::size_t kMaxWindows = 2;

    // Returns the brightness of the surroundings in a direction.
    double light_from(const Direction& direction) const {
        // Windows that do not exist have the brightness 0.
        double sum = 0.0;
        for (std::size_t k = 0; k < kMaxWindows; ++k) {
            sum += brightnesses_[k] * windows_[k].at(direction);
        }
        const double steep = 1.0 - max_value(direction.z(), 0.0);
        const double above = 0.5 + 0.5 * direction.z() / kHaze;
        const double sky = smooth_step(min_value(max_value(above, 0.0), 1.0));
        return sum + horizon_ * sky * (steep * steep) * (steep * steep);
    }

    bool has_windows_ = false;
    KernelArray<Window, kMaxWindows> windows_;
    KernelArray<double, kMaxWindows> brightnesses_;
    double horizon_ = 0.0;
    double flat_ = 0.0;  // brightness straight above
};

}  // namespace foam::texgen
