// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/bench_foams.h"

#include <benchmark/benchmark.h>

namespace foam::bench {

namespace {

// Measures consecutive frames of a coarsening foam: diffusion, T1, T2, and equilibrium to errors
// below 1e-9.
void coarsening_frame(benchmark::State& state) {
    Foam foam = equilibrated_foam(static_cast<int>(state.range(0)));
    const StepOptions options;
    StepSummary total;
    int frames = 0;
    for ([[maybe_unused]] auto _ : state) {
        const StepSummary summary =
            step(foam, ordinary_frame_time(foam, options.coarsening), options);
        if (!summary.equilibrium.converged()) {
            state.SkipWithError("no equilibrium");
            break;
        }
        total.equilibrium.iterations += summary.equilibrium.iterations;
        total.equilibrium.t1 += summary.equilibrium.t1;
        total.equilibrium.t2 += summary.equilibrium.t2;
        ++frames;
    }
    state.counters["iterations"] = static_cast<double>(total.equilibrium.iterations) / frames;
    state.counters["t1"] = static_cast<double>(total.equilibrium.t1) / frames;
    state.counters["t2"] = static_cast<double>(total.equilibrium.t2) / frames;
}

BENCHMARK(coarsening_frame)
    ->Arg(1000)
    ->Arg(10000)
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace

}  // namespace foam::bench
