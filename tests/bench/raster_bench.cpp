#include "tests/bench/bench_foams.h"
#include "texgen/maps/albedo.h"

#include <benchmark/benchmark.h>

namespace foam::bench {

namespace {

// Cells and films of 2 pixels into an sRGB image, on one thread.
void rasterized_frame(benchmark::State& state) {
    const Frame frame = snapshot(settled_foam(static_cast<int>(state.range(0))), 1);
    const int side = static_cast<int>(state.range(1));
    const texgen::RasterGrid grid{side, side};
    const texgen::AlbedoOptions options;
    const double width = texgen::film_width_in_pixels(options, grid, frame.torus);
    texgen::Image<std::uint8_t> image(side, side, 3);
    for ([[maybe_unused]] auto _ : state) {
        const texgen::CellOutlines cells = texgen::outline_cells(frame, grid, width, 1);
        texgen::write_albedo(frame, cells, options, 1, image.view());
        benchmark::ClobberMemory();
    }
}

BENCHMARK(rasterized_frame)
    ->ArgsProduct({{1000, 10000}, {1024, 2048}})
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace foam::bench
