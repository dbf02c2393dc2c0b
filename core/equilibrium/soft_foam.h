// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/geometry/film_arc.h"

#include <vector>

namespace foam {

/// The model of the foam in relaxation (E4). Bubbles are soft: their pressure depends on their
/// area. Films are arcs, and the half angle of each film is an unknown. The model consists of the
/// loaded bubbles (`load`) and their films. It has one slot for each bubble and each film of the
/// foam. Its memory can therefore be reused to relax one part of the foam after another.
class SoftFoam {
  public:
    /// The arc of a film: its half angle in radians, the sine and cosine of this angle, and its
    /// shape.
    struct Arc {
        double half_angle = 0.0;
        double sine = 0.0;
        double cosine = 1.0;
        ArcShape shape;
    };

    explicit SoftFoam(Foam& foam) : foam_(foam) {}

    /// Unloads all bubbles and sets the stiffness. `stiffness` is the resistance of a bubble to a
    /// change of its area (B of E4), in film tensions.
    void begin(double stiffness);

    /// Loads a bubble and its films from the foam. Does nothing if the bubble is loaded already, is
    /// dead, or is the ghost, whose pressure stays 0.
    void load(BubbleId bubble);

    /// Returns the pressure of a loaded bubble: its pressure at the target area plus the slope
    /// times the missing area. Returns 0 for the ghost.
    double pressure(BubbleId bubble) const { return bubbles_[bubble].pressure(); }
    /// Returns the decrease of the pressure per unit of gained area; 0 for the ghost.
    double slope(BubbleId bubble) const { return bubbles_[bubble].slope; }
    /// Adds `area` to the area of a bubble, which changes its pressure.
    void add_area(BubbleId bubble, double area) { bubbles_[bubble].area += area; }
    /// Sets the p of a bubble (E4), which is its pressure at the target area, to its present
    /// pressure, as the method of multipliers requires.
    void update_multiplier(BubbleId bubble);

    /// Returns the arc of a film along its forward side.
    const Arc& arc(FilmId film) const { return arcs_[film]; }
    /// Returns ArcShape::segment (h of E3) of the film's arc along the half-edge, positive if the
    /// arc adds to the area on the left.
    double segment_of(HalfEdgeId h) const {
        const double segment = arcs_[film_of(h)].shape.segment;
        return is_forward(h) ? segment : -segment;
    }
    /// Sets the half angle of a film along its forward side, and updates the areas of the two
    /// bubbles beside the film. If the film is an outer film, its half angle is also stored in the
    /// foam. The area of the film's segment changes because of the new half angle, and because the
    /// squared chord length has changed from `squared_before` to `squared_after`.
    void set_arc(FilmId film, double half_angle, double squared_before, double squared_after);

    /// Loads the arc of a film from the foam. The half angle of an inner film follows from the
    /// pressures; the half angle of an outer film is stored in the foam.
    void load_arc(FilmId film);
    /// Updates a bubble after the T1 rule has been applied near it: loads the arcs of its outer
    /// films and measures its area. The arcs are loaded because the rule may have joined two films
    /// into one. `may_be_empty` is true, for example, after a film has torn. If it is true and the
    /// bubble has less than half of its target area, the outer films of the bubble are bent by
    /// bulge_outer_films. Precondition: the bubble is loaded.
    void renew(BubbleId bubble, bool may_be_empty);

  private:
    // The state of a loaded bubble. Its pressure is p + B (1 - A / A_target) / sqrt(A_target) (E4),
    // which is p + slope (A_target - A).
    struct SoftBubble {
        double area = 0.0;                // A, the area within the arcs
        double pressure_at_target = 0.0;  // p
        double slope = 0.0;
        double target = 0.0;

        double pressure() const { return pressure_at_target + slope * (target - area); }
    };

    void measure(BubbleId bubble);
    void load_outer_arcs(BubbleId bubble);
    void bend_to(FilmId film, double half_angle);

    Foam& foam_;
    double stiffness_ = 0.0;
    Indexed<BubbleId, SoftBubble> bubbles_;  // the target of a bubble that is not loaded is 0
    Indexed<FilmId, Arc> arcs_;
    std::vector<BubbleId> loaded_;
};

/// Bends the outer films of a bubble so that the bubble would have its target area if its inner
/// films were straight. The area that the polygon of the bubble lacks is divided equally among the
/// segments of the outer films. Does nothing if the bubble has no outer film.
void bulge_outer_films(Foam& foam, BubbleId bubble);

}  // namespace foam
