// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

#include <Eigen/Core>

#include <vector>

namespace foam::texgen {

/// The options of the reflections in the map lit. The surface reflects up to two windows like a
/// mirror, and a sky that is brightest just above the horizon. The first window is in the direction
/// of the light. The second window has the same elevation and the opposite azimuth, and is fainter,
/// like the reflection from the back of a bubble.
struct ReflectionOptions {
    int windows = 0;
    double window_size = 30.0;       // width and height of a window, degrees
    double window_softness = 0.4;    // width of its soft border, as a fraction of its size
    double window_brightness = 1.0;  // brightness of the first window
    // Factor on the brightness of the sky. Haze halves the brightness at the horizon itself; the
    // largest brightness, slightly above the horizon, is two thirds of this factor.
    double horizon = 0.0;
};

Keys<ReflectionOptions> reflection_keys();

/// A direction: a vector of length 1 with the components right, up, and towards the viewer.
using Direction = Eigen::Vector3d;

/// Returns the direction with the given azimuth and elevation in degrees (maps/lit.h).
Direction direction_of(double azimuth, double elevation);

/// A bright square window that the surface reflects, in a given direction.
class Window {
  public:
    /// `degrees` is the width of the window, `softness` is ReflectionOptions::window_softness.
    Window(double azimuth, double elevation, double degrees, double softness);

    /// Returns the brightness in a direction, from 0 to 1.
    double at(const Direction& direction) const;

  private:
    Direction middle_;
    Direction across_;
    Direction upward_;
    double half_size_;  // half the width of the window, if it is at distance 1
    double softness_;
};

/// The surroundings that a mirror reflects (ReflectionOptions). The ground below the horizon is
/// black, with a soft transition to the sky. Borrows the options.
class Reflections {
  public:
    /// `azimuth` and `elevation` give the direction of the light, in degrees.
    Reflections(const ReflectionOptions& options, double azimuth, double elevation);

    /// Returns true if nothing is reflected.
    bool are_none() const { return windows_.empty() && options_.horizon == 0.0; }

    /// Returns the brightness that a mirror with the given normal shows to a viewer straight above
    /// it, minus the brightness that a horizontal mirror shows, but at least 0.
    double brightness(const Direction& normal) const;

  private:
    double around(const Direction& direction) const;

    const ReflectionOptions& options_;
    std::vector<Window> windows_;
    double flat_ = 0.0;  // brightness straight above
};

}  // namespace foam::texgen
