// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/bench_foams.h"

#include <benchmark/benchmark.h>

namespace foam::bench {

namespace {

// Measures the time from a raw diagram to area and angle errors below 1e-9.
void raw_to_equilibrium(benchmark::State& state) {
    const Foam raw = raw_foam(static_cast<int>(state.range(0)));
    EquilibriumSummary summary;
    for ([[maybe_unused]] auto _ : state) {
        Foam foam = raw;
        summary = equilibrate(foam, {});
        benchmark::DoNotOptimize(foam.positions);
    }
    if (!summary.converged()) {
        state.SkipWithError("no equilibrium");
    }
    state.counters["iterations"] = summary.iterations;
    state.counters["angle_error"] = summary.angle_error;
}

BENCHMARK(raw_to_equilibrium)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace

}  // namespace foam::bench
