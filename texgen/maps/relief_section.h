// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The shape of the relief across a film.
enum class ReliefProfile {
    Dome,   // every bubble is a dome between its films; a circular bubble is a spherical cap
    Ridge,  // films are rounded ridges on flat bubbles
    Wet,    // films are walls of liquid with fillets (Plateau borders) on both sides
};

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
    /// section's unit: the distance of the middle of a dome, or the distance beyond which a ridge
    /// or wet film hides practically no part of the sky.
    double reach() const { return profile_ == ReliefProfile::Dome ? 1.0 : kSkyReach; }
    static constexpr double kSkyReach = 4.0;  // reach() of all profiles but domes

    /// Returns the height at the position x on a straight line across the film. The position of the
    /// film is 0; positions on its other side are negative. For domes, x = 1 is the middle of the
    /// bubble, and x > 1 is beyond the middle.
    double height_along(double x) const;

  private:
    ReliefProfile profile_;
    double cotangent_;  // cotangent of the angle of domes
};

}  // namespace foam::texgen
