#pragma once

namespace foam::texgen {

/// What a foam looks like from the side.
enum class ReliefProfile {
    Dome,   // every bubble is a dome between its films; where it is a circle, a cap of a sphere
    Ridge,  // films are rounded ridges on flat bubbles
    Wet,    // films are walls of liquid with the fillets of Plateau borders on both sides
};

/// A section through a relief across a film, alike on both sides, in lengths of a unit of its own:
/// the radius of a bubble, or the width of what stands along films. A place has a smooth distance s
/// from films (distance.h). In a circle of radius 1 that is s = x - x²/2 at the way x from the
/// film; others than domes take s for x.
class ReliefSection {
  public:
    /// The angle of domes at films, in radians, below a right one.
    ReliefSection(ReliefProfile profile, double angle);

    /// Height at a smooth distance, which is 0 or more, and its derivative.
    double height(double smooth) const;
    double slope(double smooth) const;

    /// The way from the film at a smooth distance, of a dome up to 1, its middle; and back.
    double way(double smooth) const;
    double smooth(double way) const;

    /// The way from which on there is nothing to be seen of the film.
    double reach() const { return profile_ == ReliefProfile::Dome ? 1.0 : 4.0; }

    /// The height along a straight line across the film: at x < 0 beyond it, at x > 1 beyond the
    /// middle of a bubble.
    double height_along(double x) const;

  private:
    ReliefProfile profile_;
    double cotangent_;  // of the angle
};

}  // namespace foam::texgen
