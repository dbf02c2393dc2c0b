#include "tests/bench/bench_foams.h"
#include "texgen/image/png.h"
#include "texgen/maps/albedo.h"

#include <benchmark/benchmark.h>

namespace foam::bench {

namespace {

// An albedo as the bake encodes it, on one thread.
void encoded_png(benchmark::State& state) {
    const Frame frame = snapshot(settled_foam(static_cast<int>(state.range(0))), 1);
    const int side = static_cast<int>(state.range(1));
    const texgen::Image<std::uint8_t> image = texgen::albedo(frame, {side, side}, {}, 1);
    std::size_t bytes = 0;
    for ([[maybe_unused]] auto _ : state) {
        bytes = texgen::encode_png(image.view(), {.color = true, .text = {}}).size();
    }
    state.counters["bytes"] = static_cast<double>(bytes);
}

BENCHMARK(encoded_png)->ArgsProduct({{1000, 10000}, {1024, 2048}})->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace foam::bench
