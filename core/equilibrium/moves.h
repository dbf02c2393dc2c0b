#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

/// The values of some unknowns, saved so that a step can be undone.
struct State {
    std::vector<Vec2> positions;
    std::vector<double> pressures;
    std::vector<double> half_angles;
};

State state_of(const Foam& foam, const Unknowns& unknowns);

/// Sets the foam to a state plus a fraction of a step. Junctions may leave the fundamental cell of
/// the torus (see wrap). Half angles are clamped to (-pi, pi).
void set_state(Foam& foam,
               const Unknowns& unknowns,
               const State& state,
               const Eigen::VectorXd& step,
               double fraction);

/// Moves the free junctions back into the fundamental cell of the torus.
void wrap(Foam& foam, const Unknowns& unknowns);

/// Returns the largest fraction, up to 1, of a change of a film's chord that does not shorten it by
/// more than `largest` of its length, and does not move its ends across it by more than `largest`
/// of its length (the new length, if the whole change would lengthen it). It may grow freely.
double allowed_share(const Vec2& chord, const Vec2& change, double largest);

/// Limits the relative motion of the two ends of each film to its allowed share. Their common
/// motion is kept: a short film can travel far. The half angle of an outer film may change by up to
/// `largest` radians, and by up to that fraction of its distance from pi. Returns true if the step
/// was changed.
bool limit_moves(const Foam& foam, const Unknowns& unknowns, double largest, Eigen::VectorXd& step);

/// Returns the films that a step takes through a T1, in increasing order: those that have
/// collapsed, and those below their T1 distance that the step would shorten by more than half and
/// that stay open when flipped.
std::vector<FilmId> collapsing_films(const Foam& foam,
                                     const Unknowns& unknowns,
                                     const Eigen::VectorXd& step,
                                     const TopologyThresholds& thresholds);

/// The same for a step near equilibrium, which can be trusted: those that have collapsed, and those
/// below their T1 distance that would still be below it after the step and that stay open when
/// flipped.
std::vector<FilmId> closing_films(const Foam& foam,
                                  const Unknowns& unknowns,
                                  const Eigen::VectorXd& step,
                                  const TopologyThresholds& thresholds);

}  // namespace foam
