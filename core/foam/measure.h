#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Area of a bubble within its arcs (E1). A bubble that is turned inside out has a negative one.
double bubble_area(const Foam& foam, BubbleId bubble);

/// Area of a bubble within the chords of its films.
double polygon_area(const Foam& foam, BubbleId bubble);

/// bubble_area of every live bubble; 0 in dead slots.
Indexed<BubbleId, double> bubble_areas(const Foam& foam);

/// Radius of the circle that a lone bubble is. Its pressure is the film tension over it.
double lone_radius(const LoneBubble& bubble);

/// Shifts the pressures, which on a torus are known up to a constant, so that their area-weighted
/// mean is 0. In a patch they stay: the ghost's is 0.
void center_pressures(Foam& foam);

/// Film tension times the length of all films.
double energy(const Foam& foam);

/// Films whose half angle is held at the limit (kLargestSine): no equilibrium rests on one.
int films_at_limit(const Foam& foam);

/// Distance from equilibrium (E2). An error is NaN, and so below no tolerance, where the foam is
/// not finite.
struct EquilibriumErrors {
    double area = 0.0;   // largest |A / A_target - 1|
    double angle = 0.0;  // largest |angle - 120 degrees| between two films, radians
    double arc = 0.0;    // largest |sin(half angle) - what Laplace-Young asks for| of outer films
    int films_at_limit = 0;

    /// Whether the foam is in equilibrium but for less than a tolerance.
    bool are_below(double tolerance) const {
        return area < tolerance && angle < tolerance && arc < tolerance && films_at_limit == 0;
    }
};

EquilibriumErrors equilibrium_errors(const Foam& foam);

}  // namespace foam
