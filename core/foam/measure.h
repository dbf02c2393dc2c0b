// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns the area of a bubble within its arcs (E1 in core/EQUATIONS.md). The area of an inverted
/// bubble is negative.
double bubble_area(const Foam& foam, BubbleId bubble);

/// Returns the area of a bubble within the chords of its films.
double polygon_area(const Foam& foam, BubbleId bubble);

/// Returns bubble_area for every live bubble. The values of the ghost and of dead slots are 0.
Indexed<BubbleId, double> bubble_areas(const Foam& foam);

/// Returns the radius of a lone bubble, a circle of its target area.
double lone_radius(const LoneBubble& bubble);

/// Returns the pressure of a lone bubble: the film tension divided by its radius.
double lone_pressure(const LoneBubble& bubble, double film_tension);

/// Adds a constant to all pressures of a torus, so that their mean, weighted by target area, is 0.
/// Equilibrium determines the pressures of a torus only up to such a constant. Does nothing to a
/// patch, where pressures are relative to the pressure of the ghost.
void center_pressures(Foam& foam);

/// Returns the film tension times the total length of all films, including the circles of lone
/// bubbles.
double energy(const Foam& foam);

/// Returns the number of films at the limit: inner films whose half angle is clamped to 80 degrees
/// (kLargestSine). A foam with such a film is not in equilibrium.
int films_at_limit(const Foam& foam);

/// Distance from equilibrium (E2 in core/EQUATIONS.md). If a value of the foam is NaN, the errors
/// that depend on this value are NaN. are_below then returns false for any tolerance.
struct EquilibriumErrors {
    double area = 0.0;   // largest |A / A_target - 1|
    double angle = 0.0;  // largest |angle between two films - 120 degrees|, radians
    double arc = 0.0;    // largest |sin(half angle) - Delta c / 2T| of outer films (E1)
    int films_at_limit = 0;

    /// Returns true if every error is below the tolerance and no film is at the limit.
    bool are_below(double tolerance) const {
        return area < tolerance && angle < tolerance && arc < tolerance && films_at_limit == 0;
    }
};

/// Returns the largest errors over all bubbles of the network, all junctions and all outer films.
EquilibriumErrors equilibrium_errors(const Foam& foam);

}  // namespace foam
