// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/newton_system.h"
#include "core/foam/topology_thresholds.h"

#include <cstddef>
#include <vector>

namespace foam {

/// A foam of at least this many films is large. In nearly every step, some of its films need a T1
/// or some of its bubbles have large errors, although the step suits the rest of the foam.
inline constexpr std::size_t kLargeFoam = 60'000;

/// Options of `newton`.
struct NewtonOptions {
    int max_iterations = 40;
    // The method has converged when every force (ResidualNorms::force) is below `force_tolerance`,
    // in film tensions, and every area error is below `area_tolerance`, relative to the target
    // area.
    double force_tolerance = 1e-11;
    double area_tolerance = 1e-11;
    // The limit of one step (limit_moves), as a multiple of the chord length of a film. The two
    // ends of the film approach each other by at most about this limit. They also move across the
    // chord, relative to each other, by at most about this limit. The same number, in radians,
    // limits the change of the half angle of an outer film.
    double largest_move = 0.4;
    // The method ends with the status Slow if a step with a new factor leaves more than this share
    // of the norm of the residual. The value 1 disables this status.
    double slow_ratio = 1.0;
    // Decides which of the films that are shorter than their T1 distance need a T1 when a step has
    // been computed. If this is true and the foam is near equilibrium, these are the films that
    // would still be shorter after the step (films_staying_short). Otherwise, these are only the
    // films that the step would shorten by more than half (collapsing_films). Collapsed films
    // always need a T1.
    bool predicts_t1 = true;
    // If false, the precision of the factor is raised only near equilibrium. Farther away, defects
    // are a likelier cause of a stall than low precision is, and a factor in double precision is
    // costly in a large foam.
    bool raises_precision_far = true;
    TopologyThresholds thresholds{};
};

/// The outcome of a run of Newton's method.
enum class NewtonStatus {
    Converged,
    FilmsNeedT1,  // films need a T1, before the next step or after the last one
    Slow,         // see NewtonOptions::slow_ratio
    // A step with a new factor does not reduce the residual. The factor is in double precision,
    // with two exceptions: some films need a T1 (NewtonSummary::films_for_t1), or the foam is far
    // from equilibrium and NewtonOptions::raises_precision_far is false.
    Stalled,
    IterationLimit,
};

/// The result of `newton`.
struct NewtonSummary {
    NewtonStatus status = NewtonStatus::IterationLimit;
    int iterations = 0;  // number of steps that were made
    // The larger of two numbers: the largest force (ResidualNorms::force), in film tensions, and
    // the largest area error, relative to the target area.
    double residual = 0.0;
    std::vector<FilmId> films_for_t1;  // the films that need a T1, in increasing order
};

/// Runs Newton's method on E3 from the present state of the foam. Everything except the unknowns of
/// the system is held fixed. The method is globalized: steps are limited
/// (NewtonOptions::largest_move), and a line search requires the residual to decrease. If the line
/// search along the limited step fails, the step without limits is tried. A factor is kept for
/// further steps (the chord method) while these steps are expected to cost less than a new factor.
///
/// Precondition: the foam has the network with which the system was started.
NewtonSummary newton(Foam& foam, NewtonSystem& system, const NewtonOptions& options);

/// Runs Newton's method with a NewtonSystem of its own, on all hardware threads.
NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options);

}  // namespace foam
