#include "core/equilibrium/equilibrate.h"

#include "core/equilibrium/relaxation.h"
#include "core/equilibrium/t1_rule.h"
#include "core/foam/measure.h"

#include <vector>

namespace foam {

namespace {

class Equilibration {
  public:
    Equilibration(Foam& foam, const EquilibriumOptions& options) : foam_(foam), options_(options) {
        newton_options_.thresholds = options.thresholds;
        newton_options_.threads = options.threads;
    }

    EquilibriumSummary run() {
        if (options_.relaxes_first) {
            relax_all();
        }
        bool settled = false;
        for (int round = 0; round < options_.max_rounds && !settled; ++round) {
            settled = solve_once();
        }
        center_pressures(foam_);
        rearm_grown_films(foam_, options_.thresholds);
        report(settled);
        return summary_;
    }

  private:
    // Newton's method, then what it asks for; true where it asks for nothing.
    bool solve_once() {
        const NewtonSummary newton_summary =
            newton(foam_, all_unknowns(foam_.network), newton_options_);
        summary_.iterations += newton_summary.iterations;
        if (newton_summary.status == NewtonStatus::Converged) {
            return settle(short_films(foam_, options_.thresholds)) == 0;
        }
        if (newton_summary.status == NewtonStatus::FilmsCollapse) {
            settle(newton_summary.collapsing);
        } else {
            relax_all();
        }
        return false;
    }

    void relax_all() {
        const RelaxationSummary relaxation =
            relax(foam_, {.sweeps = options_.relaxation_sweeps, .thresholds = options_.thresholds});
        summary_.sweeps += relaxation.sweeps;
        summary_.t1 += relaxation.t1;
    }

    int settle(const std::vector<FilmId>& films) {
        int flips = 0;
        for (const FilmId film : films) {
            flips += settle_film(foam_, film, options_.thresholds, Tangents::OfArcs) ? 1 : 0;
        }
        summary_.t1 += flips;
        return flips;
    }

    void report(bool settled) {
        const EquilibriumErrors errors = equilibrium_errors(foam_);
        summary_.area_error = errors.area;
        summary_.angle_error = errors.angle;
        summary_.energy = energy(foam_);
        const bool exact = errors.area < options_.tolerance && errors.angle < options_.tolerance &&
                           errors.films_at_limit == 0;
        if (settled) {
            summary_.status =
                exact ? EquilibriumStatus::Converged : EquilibriumStatus::ToleranceMissed;
        }
    }

    Foam& foam_;
    const EquilibriumOptions& options_;
    NewtonOptions newton_options_;
    EquilibriumSummary summary_;
};

}  // namespace

EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options) {
    return Equilibration(foam, options).run();
}

}  // namespace foam
