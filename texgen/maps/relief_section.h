#pragma once

namespace foam::texgen {

/// The shape of a foam seen from the side.
enum class ReliefProfile {
    Dome,   // every bubble is a dome between its films; where it is a circle, a cap of a sphere
    Ridge,  // films are rounded ridges on flat bubbles
    Wet,    // films are walls of liquid with the fillets of Plateau borders on both sides
};

/// A section through a relief across a film, the same on both sides, in a unit of length of its
/// own: the radius of a bubble, or the width of a ridge or border. A point has a smooth distance s
/// from films (distance.h). In a circle of radius 1, s = x - x²/2 at the distance x from the film;
/// profiles other than domes use s as x.
class ReliefSection {
  public:
    /// Takes the angle of domes at films, in radians, below pi / 2.
    ReliefSection(ReliefProfile profile, double angle);

    /// Return the height at a smooth distance, which is 0 or more, and its derivative.
    double height(double smooth) const;
    double slope(double smooth) const;

    /// Convert a smooth distance to the distance x, for a dome up to its middle at 1, and back.
    double way(double smooth) const;
    double smooth(double way) const;

    /// Returns the distance beyond which the film has no effect.
    double reach() const { return profile_ == ReliefProfile::Dome ? 1.0 : 4.0; }

    /// Returns the height along a straight line across the film: beyond the film for x < 0, and
    /// beyond the middle of a bubble for x > 1.
    double height_along(double x) const;

  private:
    ReliefProfile profile_;
    double cotangent_;  // of the angle
};

}  // namespace foam::texgen
