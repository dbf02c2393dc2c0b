#pragma once

#include "core/foam/topology_thresholds.h"
#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

/// The values of some unknowns, kept to return to.
struct State {
    std::vector<Vec2> positions;
    std::vector<double> pressures;
    std::vector<double> half_angles;
};

State state_of(const Foam& foam, const Unknowns& unknowns);

/// Sets the foam to a state plus a fraction of a step; junctions may leave the torus' own cell.
/// Half angles are held within (-pi, pi).
void set_state(Foam& foam,
               const Unknowns& unknowns,
               const State& state,
               const Eigen::VectorXd& step,
               double fraction);

/// Brings the free junctions back into the torus' own cell.
void wrap(Foam& foam, const Unknowns& unknowns);

/// The largest share, up to 1, of a change of a film's chord that does not shorten it by more than
/// `largest` of its length, nor move its ends across it by more than `largest` of the length it has
/// or, where the whole change lengthens it, would have. It may grow freely.
double allowed_share(const Vec2& chord, const Vec2& change, double largest);

/// Cuts the relative motion of the two ends of each film to its allowed share. Their common motion
/// is left: a short film can travel far. The half angle of an outer film may change by as many
/// radians as `largest` is, and come nearer to pi by the same share of its distance. Returns
/// whether anything was cut.
bool limit_moves(const Foam& foam, const Unknowns& unknowns, double largest, Eigen::VectorXd& step);

/// The films that a step takes through a T1, in increasing order: the collapsed ones, and those
/// below their T1 distance that the step would shorten by more than half and that stay open when
/// flipped.
std::vector<FilmId> collapsing_films(const Foam& foam,
                                     const Unknowns& unknowns,
                                     const Eigen::VectorXd& step,
                                     const TopologyThresholds& thresholds);

/// The same for a step that can be trusted, near equilibrium: the collapsed films, and those below
/// their T1 distance that the step would leave there and that stay open when flipped.
std::vector<FilmId> closing_films(const Foam& foam,
                                  const Unknowns& unknowns,
                                  const Eigen::VectorXd& step,
                                  const TopologyThresholds& thresholds);

}  // namespace foam
