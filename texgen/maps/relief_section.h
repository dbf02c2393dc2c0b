// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The shape of a foam seen from the side.
enum class ReliefProfile {
    Dome,   // every bubble is a dome between its films; a circular bubble is a spherical cap
    Ridge,  // films are rounded ridges on flat bubbles
    Wet,    // films are walls of liquid with fillets (Plateau borders) on both sides
};

/// A cross-section of the relief perpendicular to a film, symmetric about the film. Its unit of
/// length is the radius of a bubble, or the width of a ridge or border. Heights depend on the
/// smooth distance s from films (distance_field.h). In a circle of radius 1, s = x - x²/2 at the
/// distance x from the film. Profiles other than domes use s in place of x.
class ReliefSection {
  public:
    /// `angle` is the slope angle of domes at films, in radians, between 0 and pi / 2.
    ReliefSection(ReliefProfile profile, double angle);

    /// Return the height at a smooth distance, and the derivative of the height. Precondition: the
    /// distance is not negative.
    double height(double smooth) const;
    double slope(double smooth) const;

    /// Convert a smooth distance to the distance x from the film, and back. A dome has its middle
    /// at x = 1, which is the largest x.
    double distance(double smooth) const;
    double smooth(double distance) const;

    /// Returns the distance from the film beyond which it practically hides no part of the sky.
    double reach() const { return profile_ == ReliefProfile::Dome ? 1.0 : 4.0; }

    /// Returns the height along a straight line across the film: beyond the film for x < 0, and
    /// beyond the middle of a bubble for x > 1.
    double height_along(double x) const;

  private:
    ReliefProfile profile_;
    double cotangent_;  // cotangent of the angle of domes
};

}  // namespace foam::texgen
