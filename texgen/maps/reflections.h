// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/lit.h"

#include <Eigen/Core>

#include <vector>

namespace foam::texgen {

/// A direction of length 1: right, up, towards the viewer.
using Direction = Eigen::Vector3d;

/// Returns the direction with the given azimuth and elevation in degrees (LitOptions).
Direction direction_of(double azimuth, double elevation);

/// A square window around the surface.
class Window {
  public:
    /// `degrees` is the width of the window, `softness` is LitOptions::window_softness.
    Window(double azimuth, double elevation, double degrees, double softness);

    /// Returns the brightness in a direction, from 0 to 1.
    double at(const Direction& direction) const;

  private:
    Direction middle_;
    Direction across_;
    Direction upward_;
    double half_size_;  // of the window at distance 1
    double softness_;
};

/// What the surface of the map lit reflects like a mirror: windows, and a sky that is brightest at
/// the horizon (LitOptions). The ground below the horizon is black. Borrows the options.
class Reflections {
  public:
    explicit Reflections(const LitOptions& options);

    /// Returns true if nothing is reflected.
    bool are_none() const { return windows_.empty() && options_.horizon == 0.0; }

    /// Returns the brightness that a mirror with the given normal shows to a viewer straight above
    /// it, minus the brightness that a horizontal mirror shows, but at least 0.
    double brightness(const Direction& normal) const;

  private:
    double around(const Direction& direction) const;

    const LitOptions& options_;
    std::vector<Window> windows_;
    double flat_ = 0.0;  // brightness straight above
};

}  // namespace foam::texgen
