#pragma once

#include "core/foam/foam.h"
#include "core/geometry/film_arc.h"

#include <vector>

namespace foam {

/// A foam as relaxation (E4) sees it: bubbles that give way, and films that are arcs with half
/// angles of their own. Knows those that have been loaded; its memory, one value for each bubble
/// and each film, serves one part of the foam after the other.
class SoftFoam {
  public:
    struct Arc {
        double half_angle = 0.0;
        double sine = 0.0;
        double cosine = 1.0;
        ArcShape shape;
    };

    explicit SoftFoam(Foam& foam) : foam_(foam) {}

    /// Forgets what has been loaded. Stiffness of a bubble against a change of its area, in film
    /// tensions.
    void begin(double stiffness);

    /// A bubble and its films, as the foam has them; nothing where it is loaded already or is the
    /// ghost, which has no stiffness and no pressure.
    void load(BubbleId bubble);

    /// That of its target, and more the more it lacks of it; 0 of the ghost.
    double pressure(BubbleId bubble) const { return bubbles_[bubble].pressure(); }
    /// What the pressure loses per area gained.
    double slope(BubbleId bubble) const { return bubbles_[bubble].slope; }
    void add_area(BubbleId bubble, double area) { bubbles_[bubble].area += area; }
    /// The pressure that the bubble has now becomes the one of its target.
    void keep_pressure(BubbleId bubble);

    /// Along its forward side.
    const Arc& arc(FilmId film) const { return arcs_[film]; }
    /// ArcShape::segment along the half-edge.
    double segment_of(HalfEdgeId h) const {
        const double segment = arcs_[film_of(h)].shape.segment;
        return is_forward(h) ? segment : -segment;
    }
    /// Gives the film another half angle, that of an outer one in the foam, too, and the bubbles on
    /// its sides their areas, from the squared chord before and after.
    void set_arc(FilmId film, double half_angle, double squared_before, double squared_after);

    /// Takes the arc that the film has by the foam's pressures or, an outer one, by its half angle.
    void take_arc(FilmId film);
    /// The same for the outer films of a bubble, and measures its area anew: after a change of the
    /// network, where one that has been kept may stand for two. Of a bubble that may be left next
    /// to nothing, as where a film tears, they are made to bulge if it is.
    void renew(BubbleId bubble, bool may_be_empty);

  private:
    // A bubble in the energy of E4: p + B (1 - A / A_target) / sqrt(A_target), where p is to become
    // the pressure at which it has its target.
    struct SoftBubble {
        double area = 0.0;  // within the arcs; kept up to date
        double pressure_at_target = 0.0;
        double slope = 0.0;
        double target = 0.0;

        double pressure() const { return pressure_at_target + slope * (target - area); }
    };

    void measure(BubbleId bubble);
    void take_outer_arcs(BubbleId bubble);
    void bend_to(FilmId film, double half_angle);

    Foam& foam_;
    double stiffness_ = 0.0;
    Indexed<BubbleId, SoftBubble> bubbles_;  // of no target where not loaded
    Indexed<FilmId, Arc> arcs_;
    std::vector<BubbleId> loaded_;
};

/// Lays what a bubble lacks of its target within its chords into the segments of its outer films.
void bulge_outer_films(Foam& foam, BubbleId bubble);

}  // namespace foam
