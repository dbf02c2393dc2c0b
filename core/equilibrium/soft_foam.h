#pragma once

#include "core/foam/foam.h"
#include "core/geometry/film_arc.h"

#include <vector>

namespace foam {

/// The foam of relaxation (E4): soft bubbles, whose pressure depends on their area, and films that
/// are arcs with half angles of their own. Holds the bubbles that have been loaded, and their
/// films. Its memory, one slot for each bubble and each film, serves one part of the foam after
/// another.
class SoftFoam {
  public:
    struct Arc {
        double half_angle = 0.0;
        double sine = 0.0;
        double cosine = 1.0;
        ArcShape shape;
    };

    explicit SoftFoam(Foam& foam) : foam_(foam) {}

    /// Forgets all loaded bubbles. `stiffness` is that of a bubble against a change of its area, in
    /// film tensions.
    void begin(double stiffness);

    /// Loads a bubble and its films from the foam. Does nothing if the bubble is loaded already,
    /// has gone, or is the ghost, which has no stiffness and no pressure.
    void load(BubbleId bubble);

    /// Returns the pressure at the target area, raised by what the bubble lacks of that area; 0 for
    /// the ghost.
    double pressure(BubbleId bubble) const { return bubbles_[bubble].pressure(); }
    /// Returns the loss of pressure per area gained.
    double slope(BubbleId bubble) const { return bubbles_[bubble].slope; }
    void add_area(BubbleId bubble, double area) { bubbles_[bubble].area += area; }
    /// Makes the present pressure the one at the target area (method of multipliers, E4).
    void keep_pressure(BubbleId bubble);

    /// The film's arc, along its forward side.
    const Arc& arc(FilmId film) const { return arcs_[film]; }
    /// Returns ArcShape::segment along the half-edge.
    double segment_of(HalfEdgeId h) const {
        const double segment = arcs_[film_of(h)].shape.segment;
        return is_forward(h) ? segment : -segment;
    }
    /// Sets the half angle of a film, for an outer film in the foam, too, and updates the areas of
    /// the bubbles beside it, from the squared chord before and after.
    void set_arc(FilmId film, double half_angle, double squared_before, double squared_after);

    /// Loads the film's arc: for an inner film as the foam's pressures give it, for an outer film
    /// by its half angle.
    void load_arc(FilmId film);
    /// Loads the arcs of the bubble's outer films and measures its area anew, after a change of the
    /// network, which may have joined two films into one. With `may_be_empty`, as where a film has
    /// torn, a bubble with less than half of its target area gets outer films that bulge.
    void renew(BubbleId bubble, bool may_be_empty);

  private:
    // The pressure of a bubble is p + B (1 - A / A_target) / sqrt(A_target) (E4).
    struct SoftBubble {
        double area = 0.0;                // A, within the arcs
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
    Indexed<BubbleId, SoftBubble> bubbles_;  // with target 0 if not loaded
    Indexed<FilmId, Arc> arcs_;
    std::vector<BubbleId> loaded_;
};

/// Bends the outer films of a bubble so that their segments hold, in equal shares, what its polygon
/// lacks of the target area.
void bulge_outer_films(Foam& foam, BubbleId bubble);

}  // namespace foam
