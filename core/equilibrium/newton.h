#pragma once

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/foam/topology_thresholds.h"
#include "core/equilibrium/unknowns.h"

#include <optional>
#include <vector>

namespace foam {

struct NewtonOptions {
    int max_iterations = 40;
    double force_tolerance = 1e-11;  // stops when every force is below this, in film tensions ...
    double area_tolerance = 1e-11;   // ... and every area error is, relative to the target
    double largest_move = 0.4;       // of a junction in an iteration, in its shortest films
    // Stops where a step with a new factor leaves more than this share of the residual (Slow).
    double slow_ratio = 1.0;
    bool foresees_t1 = true;  // near equilibrium, from the step (see closing_films)
    TopologyThresholds thresholds{};
    int threads = 0;  // same bits for any number; 0: as many as run at once
};

enum class NewtonStatus {
    Converged,
    FilmsCollapse,  // the step takes some films through a T1, which they await
    Slow,           // see NewtonOptions::slow_ratio
    Stalled,        // no step reduces the residual
    IterationLimit,
};

struct NewtonSummary {
    NewtonStatus status = NewtonStatus::IterationLimit;
    int iterations = 0;
    double residual = 0.0;           // larger of the largest force and area error, as above
    std::vector<FilmId> collapsing;  // in increasing order
};

/// Newton's method on E3, globalized: no step shortens or turns a film by more than a fraction of
/// it, and a line search demands that the residual shrinks. A factor is kept for further steps
/// (the chord method) while these converge faster than it could be renewed. Works on a few
/// unknowns as on all.
class NewtonSolver {
  public:
    explicit NewtonSolver(const NewtonOptions& options) : options_(options) {}

    NewtonOptions& options() { return options_; }

    /// To be called first, and again whenever the network has changed. Keeps memory from before.
    void start(const Foam& foam, Unknowns unknowns);

    /// Goes on from the foam's present state. The foam must have the network of `start`.
    NewtonSummary run(Foam& foam);

  private:
    friend class NewtonRun;

    void start_linear_solver(const Foam& foam, Precision precision);
    void renew_factor(const Foam& foam);

    NewtonOptions options_;
    Unknowns unknowns_;
    std::optional<Hessian> hessian_;
    LinearSolver solver_;
    Precision precision_ = Precision::Double;
    bool is_whole_ = false;  // nothing is held
    bool has_factor_ = false;
};

/// The same in one call.
NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options);

}  // namespace foam
