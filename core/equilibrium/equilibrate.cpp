#include "core/equilibrium/equilibrate.h"

#include "core/equilibrium/drift.h"
#include "core/equilibrium/relaxation.h"
#include "core/equilibrium/residual.h"
#include "core/equilibrium/spots.h"
#include "core/foam/t1_rule.h"
#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace foam {

namespace {

// A step of the whole foam that leaves more than this share of the residual is held up by spots.
constexpr double kSlowRatio = 0.1;
// Within a spot, whose surroundings are held, there is no need to be exact.
constexpr double kSpotTolerance = 1e-3;
constexpr int kSpotIterations = 12;
constexpr int kSpotRounds = 5;   // each ended by T1s or by relaxation
constexpr int kSpotSweeps = 30;  // of relaxation
// Around what is bad where Newton's method has stalled.
constexpr int kRelaxedRings = 3;
constexpr double kWorstShare = 0.2;
constexpr int kMostLocalRelaxations = 4;     // one after another, before all is relaxed
constexpr int kFewAtLimit = 10;              // films, as around a bubble of two sides
constexpr int kMostFurtherRelaxations = 10;  // of a foam that is still far from equilibrium
// Where T1s in spots have led nowhere in so many rounds, the foam is relaxed and goes on without.
constexpr int kRoundsWithSpots = 20;

NewtonOptions whole_options(const EquilibriumOptions& options) {
    NewtonOptions whole;
    whole.thresholds = options.thresholds;
    whole.threads = options.threads;
    return whole;
}

NewtonOptions spot_options(const EquilibriumOptions& options) {
    NewtonOptions spot;
    spot.max_iterations = kSpotIterations;
    spot.force_tolerance = kSpotTolerance;
    spot.area_tolerance = kSpotTolerance;
    spot.thresholds = options.thresholds;
    spot.threads = 1;
    return spot;
}

GaussSeidelOptions gauss_seidel_options(const EquilibriumOptions& options) {
    GaussSeidelOptions sweeps;
    sweeps.tolerance = options.tolerance;
    sweeps.order =
        options.solver == Solver::ColoredGaussSeidel ? SweepOrder::Colored : SweepOrder::Sequential;
    sweeps.thresholds = options.thresholds;
    sweeps.threads = options.threads;
    return sweeps;
}

class Equilibration {
  public:
    Equilibration(Foam& foam, const EquilibriumOptions& options)
        : foam_(foam),
          options_(options),
          whole_(whole_options(options)),
          spot_(spot_options(options)),
          soft_(foam),
          without_spots_(options.solver != Solver::Newton) {}

    EquilibriumSummary run() {
        const Positions before = foam_.positions;
        // A tangle is no state for Newton's method: its T1s would lead anywhere.
        if (untangle(foam_) > 0 || options_.relaxes_first) {
            relax_all(true);
        }
        settle_spots();
        bool settled = false;
        for (int round = 0; round < options_.max_rounds && !settled; ++round) {
            if (round == kRoundsWithSpots && !without_spots_) {
                start_over_without_spots();
            }
            settled = options_.solver == Solver::Newton ? solve_by_newton() : solve_by_sweeps();
        }
        undo_drift(foam_, before);
        center_pressures(foam_);
        rearm_grown_films(foam_, options_.thresholds);
        report(settled);
        return summary_;
    }

  private:
    // Newton's method for the whole foam, then what it asks for; true where it asks for nothing.
    bool solve_by_newton() {
        if (foam_.network.film_count() == 0) {
            return true;
        }
        if (network_changed_) {
            whole_.start(foam_, all_unknowns(foam_.network));
            network_changed_ = false;
        }
        const NewtonSummary newton_summary = whole_.run(foam_);
        summary_.iterations += newton_summary.iterations;
        whole_.options().slow_ratio = without_spots_ ? 1.0 : kSlowRatio;
        switch (newton_summary.status) {
            case NewtonStatus::Converged:
                if (films_at_limit(foam_) > 0) {  // no equilibrium
                    relax_all();
                } else if (settle(short_films(foam_, options_.thresholds)) == 0) {
                    return true;
                }
                settle_spots();
                break;
            case NewtonStatus::FilmsCollapse:
                settle(newton_summary.collapsing);
                settle_spots();
                break;
            case NewtonStatus::Slow:
                if (settle_spots() == 0) {
                    whole_.options().slow_ratio = 1.0;  // it is slow all over: to go on
                }
                break;
            case NewtonStatus::Stalled:
            case NewtonStatus::IterationLimit:
                relax_where_stalled();
                settle_spots();
                break;
        }
        return false;
    }

    // The paper's solver for the whole foam, then the T1s that are due; true where none is.
    bool solve_by_sweeps() {
        const GaussSeidelSummary sweeps = gauss_seidel(foam_, gauss_seidel_options(options_));
        summary_.iterations += sweeps.sweeps;
        summary_.t1 += sweeps.t1;
        return sweeps.status == GaussSeidelStatus::SweepLimit ||
               settle(short_films(foam_, options_.thresholds)) == 0;
    }

    // Newton's method on what is far from equilibrium alone, if that is little. Returns the number
    // of spots.
    std::size_t settle_spots() {
        if (without_spots_) {
            return 0;
        }
        const Unknowns all = all_unknowns(foam_.network);
        const std::vector<Spot> spots =
            find_spots(foam_, all, residual(foam_, all, options_.threads), {});
        for (const Spot& spot : spots) {
            settle_spot(spot);
        }
        return spots.size();
    }

    // Where Newton's method stalls in a spot, the spot alone is relaxed, once: left as it is, it
    // would stop every step of the whole foam.
    void settle_spot(Spot spot) {
        bool was_relaxed = false;
        for (int round = 0; round < kSpotRounds; ++round) {
            drop_loose(spot);
            if (spot.empty()) {
                return;
            }
            Unknowns part = unknowns_around(foam_.network, spot);
            spot_.start(foam_, part);
            const NewtonSummary newton_summary = spot_.run(foam_);
            if (newton_summary.status == NewtonStatus::FilmsCollapse) {
                settle(newton_summary.collapsing);
            } else if (newton_summary.status == NewtonStatus::Converged || was_relaxed) {
                return;
            } else {
                relax_part(std::move(part), kSpotSweeps);
                was_relaxed = true;
            }
        }
    }

    // Bubbles may have come loose where films of a spot before it have torn.
    void drop_loose(Spot& spot) const {
        std::erase_if(spot, [&](BubbleId bubble) { return !foam_.network.is_live(bubble); });
    }

    void start_over_without_spots() {
        without_spots_ = true;
        whole_.options().slow_ratio = 1.0;
        whole_.options().foresees_t1 = false;
        relax_all();
    }

    // A large foam stalls for the sake of a few bubbles: to relax them alone leaves the rest as it
    // is. Where that does not help, all of it is relaxed.
    void relax_where_stalled() {
        untangle(foam_);  // a whole step of Newton's method may leave a tangle
        std::vector<Spot> spots = worst_spots();
        if (without_spots_ || spots.empty() || ++local_relaxations_ % kMostLocalRelaxations == 0) {
            relax_all();
            return;
        }
        for (Spot& spot : spots) {
            drop_loose(spot);
            if (!spot.empty()) {
                relax_part(unknowns_around(foam_.network, spot), options_.relaxation_sweeps);
            }
        }
    }

    // Where the residual is of the order of its largest.
    std::vector<Spot> worst_spots() const {
        const Unknowns all = all_unknowns(foam_.network);
        const Eigen::VectorXd r = residual(foam_, all, options_.threads);
        const ResidualNorms worst = norms(foam_, all, r);
        SpotOptions worst_options;
        worst_options.force = std::max(worst_options.force, kWorstShare * worst.force);
        worst_options.area = std::max(worst_options.area, kWorstShare * worst.area);
        worst_options.rings = kRelaxedRings;
        return find_spots(foam_, all, r, worst_options);
    }

    void relax_part(Unknowns part, int sweeps) {
        const RelaxationSummary relaxation =
            relax(foam_,
                  std::move(part),
                  {.sweeps = sweeps, .begins_anew = false, .thresholds = options_.thresholds},
                  soft_);
        summary_.t1 += relaxation.t1;
        network_changed_ = network_changed_ || relaxation.t1 > 0;
    }

    void relax_all(bool begins_anew = false) {
        begins_anew = untangle(foam_) > 0 || begins_anew || is_far();
        relax_whole(std::max(1, options_.relaxation_sweeps >> (2 * (relaxations_++ % 4))),
                    begins_anew);
        const bool is_crooked = films_at_limit(foam_) > kFewAtLimit;
        const auto goes_on = [&] {
            return is_far_all_over() || (is_crooked && films_at_limit(foam_) > 0);
        };
        for (int k = 0; k < kMostFurtherRelaxations && goes_on(); ++k) {
            relax_whole(options_.relaxation_sweeps, false);
        }
    }

    bool is_far() const { return films_at_limit(foam_) > 0 || is_far_all_over(); }

    void relax_whole(int sweeps, bool begins_anew) {
        const RelaxationSummary relaxation =
            relax(foam_,
                  all_unknowns(foam_.network),
                  {.sweeps = sweeps, .begins_anew = begins_anew, .thresholds = options_.thresholds},
                  soft_);
        summary_.sweeps += relaxation.sweeps;
        summary_.t1 += relaxation.t1;
        network_changed_ = true;
    }

    // Whether a patch is far from equilibrium, and not in spots alone. A torus holds itself, and to
    // begin anew again and again would shut its two-sided bubbles.
    bool is_far_all_over() const {
        if (!foam_.domain.is_plane()) {
            return false;
        }
        const Unknowns all = all_unknowns(foam_.network);
        const Eigen::VectorXd r = residual(foam_, all, options_.threads);
        const ResidualNorms worst = norms(foam_, all, r);
        const bool is_near = worst.force < SpotOptions{}.force && worst.area < SpotOptions{}.area;
        return !is_near && find_spots(foam_, all, r, {}).empty();
    }

    int settle(const std::vector<FilmId>& films) {
        int flips = 0;
        for (const FilmId film : films) {
            if (!foam_.network.is_live(film)) {  // gone with one before it
                continue;
            }
            flips += settle_film(foam_, film, options_.thresholds, Tangents::OfArcs) ? 1 : 0;
        }
        summary_.t1 += flips;
        network_changed_ = network_changed_ || flips > 0;
        return flips;
    }

    void report(bool settled) {
        const EquilibriumErrors errors = equilibrium_errors(foam_);
        summary_.area_error = errors.area;
        summary_.angle_error = errors.angle;
        summary_.energy = energy(foam_);
        if (settled) {
            summary_.status = errors.are_below(options_.tolerance)
                                  ? EquilibriumStatus::Converged
                                  : EquilibriumStatus::ToleranceMissed;
        }
    }

    Foam& foam_;
    const EquilibriumOptions& options_;
    NewtonSolver whole_;
    NewtonSolver spot_;
    SoftFoam soft_;
    bool without_spots_;  // Gauss-Seidel knows none
    // Every further one has a quarter of the sweeps, down to one, then all again: Newton's method
    // is to start from another state than the one that it stalled from before.
    int relaxations_ = 0;
    int local_relaxations_ = 0;
    bool network_changed_ = true;  // since whole_ was started
    EquilibriumSummary summary_;
};

}  // namespace

EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options) {
    if (foam.network.film_count() == 0) {  // lone bubbles, which are circles already, or nothing
        EquilibriumSummary summary;
        summary.status = EquilibriumStatus::Converged;
        summary.energy = energy(foam);
        return summary;
    }
    return Equilibration(foam, options).run();
}

}  // namespace foam
