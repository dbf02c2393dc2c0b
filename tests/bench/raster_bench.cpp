// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/bench_foams.h"
#include "tests/support/albedo_image.h"

#include <benchmark/benchmark.h>

namespace foam::bench {

namespace {

// Measures the time of an albedo map, with films 2 pixels wide, on one thread. The result is an
// sRGB image.
void rasterized_frame(benchmark::State& state) {
    const Frame frame = snapshot(equilibrated_foam(static_cast<int>(state.range(0))), 1);
    const int side = static_cast<int>(state.range(1));
    const texgen::RasterGrid grid{side, side};
    const texgen::AlbedoOptions options;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(test::albedo_image(frame, grid, options, 1));
    }
}

BENCHMARK(rasterized_frame)
    ->ArgsProduct({{1000, 10000}, {1024, 2048}})
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace foam::bench
