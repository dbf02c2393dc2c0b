// SPDX-License-Identifier: Apache-2.0

// Compares the paper's solver (Gauss-Seidel) with the fast solver (Newton's method):
//
//     gauss_seidel_bench [SECONDS] [--benchmark_filter=REGEX ...]
//
// A run of Gauss-Seidel that has not converged after SECONDS (140 by default) is stopped, and its
// label says so. All benchmarks together take about 8 minutes.

#include "core/foam/measure.h"
#include "core/reference/gauss_seidel.h"
#include "tests/bench/bench_foams.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <utility>

namespace foam::bench {

namespace {

constexpr double kDefaultLimit = 140.0;  // seconds
// Gauss-Seidel runs in slices, and the time is checked between them. A slice has as many sweeps as
// there are between two T1s of all short films, so that slicing does not change the result.
constexpr int kSweepsPerSlice = 30;
constexpr int kTolerances[] = {-2, -4, -6};  // powers of ten
constexpr int kComparedTolerance = -4;       // compared with the fast solver at 1e-9

struct Seconds {
    double wall = 0.0;
    double processor = 0.0;  // sum over all threads
};

class Stopwatch {
  public:
    Seconds read() const {
        const std::chrono::duration<double> wall = Clock::now() - wall_start_;
        return {wall.count(),
                static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC};
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point wall_start_ = Clock::now();
    std::clock_t processor_start_ = std::clock();
};

// Returns the input of the solver in a time step: a foam in equilibrium whose target areas have
// changed by the diffusion of one ordinary frame.
Foam frame(int bubbles) {
    Foam foam = equilibrated_foam(bubbles);
    diffuse(foam, ordinary_frame_time(foam, {}), {});
    collapse_due(foam, {});
    compact(foam);
    return foam;
}

// Returns the shortest times of several runs of the fast solver to 1e-9 from the same start.
Seconds fast_seconds(benchmark::State& state, const Foam& start, bool is_far) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Seconds best{kInfinity, kInfinity};
    for (int run = 0; run < 5; ++run) {
        Foam foam = start;
        const Stopwatch stopwatch;
        const EquilibriumSummary summary = equilibrate(foam, {.relaxes_first = is_far});
        const Seconds seconds = stopwatch.read();
        if (!summary.converged()) {
            state.SkipWithError("no equilibrium by the fast solver");
        }
        best.wall = std::min(best.wall, seconds.wall);
        best.processor = std::min(best.processor, seconds.processor);
    }
    return best;
}

// A foam that is brought to equilibrium by Gauss-Seidel.
class SweptFoam {
  public:
    SweptFoam(Foam foam, SweepOrder order, double limit)
        : foam_(std::move(foam)), order_(order), limit_(limit) {}

    // Returns false if the time limit is reached before the errors are below the tolerance.
    bool sweep_to(double tolerance) {
        const GaussSeidelOptions options{
            .tolerance = tolerance, .max_sweeps = kSweepsPerSlice, .order = order_};
        bool converged = false;
        while (!converged && seconds().wall < limit_) {
            const GaussSeidelSummary summary = gauss_seidel(foam_, options);
            sweeps_ += summary.sweeps;
            converged = summary.status == GaussSeidelStatus::Converged;
        }
        return converged;
    }

    int sweeps() const { return sweeps_; }
    Seconds seconds() const { return stopwatch_.read(); }

    double error() const {
        const EquilibriumErrors errors = equilibrium_errors(foam_);
        return std::max(errors.area, errors.angle);
    }

  private:
    Foam foam_;
    SweepOrder order_;
    double limit_;
    int sweeps_ = 0;
    Stopwatch stopwatch_;
};

void compare(benchmark::State& state, const Seconds& sweeps, const Seconds& fast) {
    state.counters["fast_ms"] = 1e3 * fast.wall;
    state.counters["wall_ratio"] = sweeps.wall / fast.wall;
    state.counters["cpu_ratio"] = sweeps.processor / fast.processor;
}

std::string time_is_up(const SweptFoam& foam, bool has_compared) {
    return fmt::format("time limit reached after {} sweeps, errors are {:.1e}{}",
                       foam.sweeps(),
                       foam.error(),
                       has_compared ? "" : ": ratios are lower bounds");
}

// Counts the sweeps to each tolerance. Compares times at kComparedTolerance or, if it is not
// reached, at the time limit.
void sweep(benchmark::State& state, SweptFoam foam, const Seconds& fast) {
    bool has_compared = false;
    for (const int exponent : kTolerances) {
        const bool converged = foam.sweep_to(std::pow(10.0, exponent));
        if (!has_compared && (!converged || exponent == kComparedTolerance)) {
            compare(state, foam.seconds(), fast);
        }
        if (!converged) {
            state.SetLabel(time_is_up(foam, has_compared));
            return;
        }
        has_compared = has_compared || exponent == kComparedTolerance;
        state.counters[fmt::format("to_1e{}", exponent)] = foam.sweeps();
    }
}

struct Case {
    const char* name;
    Foam (*start)(int bubbles);
    bool is_far;  // whether the start is far from equilibrium
    SweepOrder order;
    int largest;  // number of bubbles
};

constexpr Case kCases[] = {
    {"frame/sequential", frame, false, SweepOrder::Sequential, 10000},
    {"frame/colored", frame, false, SweepOrder::Colored, 10000},
    {"raw_diagram/sequential", raw_foam, true, SweepOrder::Sequential, 1000},
};

// Adds a benchmark from one start to equilibrium. The counter `to_1e-2` is the number of sweeps to
// errors below 1e-2, and so on. The ratios are the times of Gauss-Seidel to 1e-4 divided by the
// times of the fast solver to 1e-9.
void add_benchmark(const Case& c, double limit) {
    const auto run = [c, limit](benchmark::State& state) {
        const Foam start = c.start(static_cast<int>(state.range(0)));
        const Seconds fast = fast_seconds(state, start, c.is_far);
        for ([[maybe_unused]] auto _ : state) {
            sweep(state, SweptFoam(start, c.order, limit), fast);
        }
    };
    benchmark::RegisterBenchmark(c.name, run)
        ->RangeMultiplier(10)
        ->Range(100, c.largest)
        ->Iterations(1)
        ->Unit(benchmark::kSecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const double limit = argc > 1 ? std::strtod(argv[1], nullptr) : foam::bench::kDefaultLimit;
    for (const foam::bench::Case& c : foam::bench::kCases) {
        foam::bench::add_benchmark(c, limit);
    }
    benchmark::RunSpecifiedBenchmarks();
}
