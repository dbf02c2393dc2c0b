// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/life.h"

#include "tests/stress/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <utility>

namespace foam::stress {

namespace {

constexpr std::size_t kFewestBubbles = 4;  // a torus ends with this number of bubbles
// A life fails if no T2 happens in the time in which a five-sided bubble would lose this many mean
// areas.
constexpr double kMaxAreasWithoutT2 = 100.0;

bool is_honeycomb(const Network& network) {
    int others = 0;
    for (const BubbleId bubble : network.bubbles()) {
        others += network.sides(bubble) == 6 ? 0 : 1;
    }
    return others == 0;
}

class Life {
  public:
    Life(const FoamCase& foam_case, const LifeOptions& options)
        : case_(foam_case), options_(options) {}

    LifeSummary run() {
        const std::clock_t start = std::clock();
        try {
            seed_and_equilibrate();
            while (!summary_.failure && !at_end()) {
                advance();
            }
        } catch (const std::exception& error) {
            fail(fmt::format("exception: {}", error.what()));
        }
        summary_.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        return std::move(summary_);
    }

  private:
    void seed_and_equilibrate() {
        foam_ = seed_case(case_);
        summary_.bubbles_left = bubbles_of(foam_);
        examine(equilibrate(foam_, case_.step.equilibrium));
    }

    void advance() {
        ++summary_.frames;
        const StepSummary result = step(foam_, frame_time(foam_, case_), case_.step);
        summary_.substeps += result.substeps;
        const auto vanished = static_cast<std::size_t>(result.equilibrium.t2);
        if (bubbles_of(foam_) + vanished != summary_.bubbles_left) {
            fail("the number of bubbles does not fit the number of T2");
        }
        areas_since_t2_ = vanished > 0 ? 0.0 : areas_since_t2_ + case_.frame_fraction;
        summary_.bubbles_left = bubbles_of(foam_);
        examine(result.equilibrium);
        if (areas_since_t2_ > kMaxAreasWithoutT2) {
            fail("no bubble vanishes any more");
        }
    }

    void examine(const EquilibriumSummary& equilibrium) {
        summary_.t1 += equilibrium.t1;
        summary_.t2 += equilibrium.t2;
        const EquilibriumErrors errors = equilibrium_errors(foam_);
        if (options_.verbose) {
            print_frame(equilibrium, errors);
        }
        if (!equilibrium.converged()) {
            fail(fmt::format("no equilibrium: {}", name_of(equilibrium.status)));
        } else if (const auto unsound = find_unsoundness(foam_, options_.tolerance)) {
            fail(*unsound);
        }
        summary_.worst.area = std::max(summary_.worst.area, errors.area);
        summary_.worst.angle = std::max(summary_.worst.angle, errors.angle);
    }

    bool at_end() const {
        const bool is_over = case_.outline ? bubbles_of(foam_) == 0
                                           : foam_.network.bubble_count() <= kFewestBubbles ||
                                                 is_honeycomb(foam_.network);
        return is_over || (options_.max_frames > 0 && summary_.frames >= options_.max_frames);
    }

    // Records the first failure. Later failures are ignored.
    void fail(const std::string& reason) {
        if (!summary_.failure) {
            summary_.failure = LifeFailure{summary_.frames, reason};
        }
    }

    void print_frame(const EquilibriumSummary& equilibrium, const EquilibriumErrors& errors) const {
        fmt::print(stderr,
                   "  frame {}: {} bubbles, substep {}, {} iterations, {} sweeps, {} T1, {} T2, "
                   "area {:.1e}, angle {:.1e}\n",
                   summary_.frames,
                   bubbles_of(foam_),
                   summary_.substeps,
                   equilibrium.iterations,
                   equilibrium.sweeps,
                   equilibrium.t1,
                   equilibrium.t2,
                   errors.area,
                   errors.angle);
    }

    const FoamCase& case_;
    const LifeOptions& options_;
    Foam foam_;
    double areas_since_t2_ = 0.0;
    LifeSummary summary_;
};

}  // namespace

LifeSummary live(const FoamCase& foam_case, const LifeOptions& options) {
    return Life(foam_case, options).run();
}

std::string describe(const LifeSummary& summary) {
    const std::string verdict =
        summary.failure
            ? fmt::format("FAILED in frame {}: {}", summary.failure->frame, summary.failure->reason)
            : fmt::format("{} left", summary.bubbles_left);
    return fmt::format(
        "{}; {} frames, {} substeps, {} T1, {} T2, area {:.1e}, angle {:.1e}, {:.1f} s",
        verdict,
        summary.frames,
        summary.substeps,
        summary.t1,
        summary.t2,
        summary.worst.area,
        summary.worst.angle,
        summary.seconds);
}

}  // namespace foam::stress
