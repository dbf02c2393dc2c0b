// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"
#include "core/foam/topology_thresholds.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

/// The saved values of some unknowns, in the order of these unknowns. From a saved state, Newton's
/// method tries several fractions of a step, or undoes the step.
struct State {
    std::vector<Vec2> positions;
    std::vector<double> pressures;
    std::vector<double> half_angles;
};

/// Returns the present values of the unknowns.
State state_of(const Foam& foam, const Unknowns& unknowns);

/// Sets the unknowns of the foam to a saved state plus `fraction` times a step. Junctions may leave
/// the fundamental cell of the torus; `wrap` moves them back. Half angles are clamped to (-pi, pi).
void set_state(Foam& foam,
               const Unknowns& unknowns,
               const State& state,
               const Eigen::VectorXd& step,
               double fraction);

/// Moves the free junctions back into the fundamental cell of the torus.
void wrap(Foam& foam, const Unknowns& unknowns);

/// Returns the largest fraction, up to 1, of a change of a film's chord for which the vector
/// fraction * change meets two limits:
/// - Its component along the chord shortens the chord by at most `largest` times the chord length.
///   Lengthening is not limited.
/// - Its component across the chord is at most `largest` times a reference length.
///
/// The reference length is the chord length. If the change lengthens the chord, the component of
/// `change` along the chord is added to the reference length. Returns 1 for a chord of length 0.
double allowed_fraction(const Vec2& chord, const Vec2& change, double largest);

/// Limits the relative motion of the two ends of each film to its allowed fraction
/// (allowed_fraction), by a few sweeps over the films. Since a limited film changes the motion of
/// its neighbors, a film may still exceed its limit after the last sweep. The common motion of the
/// two ends is kept, so that a short film can move far. The half angle of an outer film may change
/// by at most `largest` radians. The change is also at most `largest` times the distance of the
/// half angle from pi, or from -pi if the half angle decreases. Returns true if the step was
/// changed.
bool limit_moves(const Foam& foam, const Unknowns& unknowns, double largest, Eigen::VectorXd& step);

/// Returns the films that need a T1 before the step is made, in increasing order. These are all
/// films that have collapsed (collapsed_length), and every other film that meets three conditions:
/// - it is shorter than its T1 distance, and the step would shorten it by more than half;
/// - it can flip or tear;
/// - by the forces before the step, the flipped film would not shrink again, or the two bubbles
///   beside the torn film would not be pulled together again.
std::vector<FilmId> collapsing_films(const Foam& foam,
                                     const Unknowns& unknowns,
                                     const Eigen::VectorXd& step,
                                     const TopologyThresholds& thresholds);

/// Returns the films that need a T1 before a step near equilibrium is made, in increasing order.
/// These are all films that have collapsed, and every other film that meets three conditions:
/// - it is shorter than its T1 distance now, and would still be shorter after the step;
/// - it can flip or tear;
/// - by the forces before the step, the flipped film would not shrink again, or the two bubbles
///   beside the torn film would not be pulled together again.
///
/// The length after the step decides because such a step predicts the length in equilibrium well.
std::vector<FilmId> films_staying_short(const Foam& foam,
                                        const Unknowns& unknowns,
                                        const Eigen::VectorXd& step,
                                        const TopologyThresholds& thresholds);

}  // namespace foam
