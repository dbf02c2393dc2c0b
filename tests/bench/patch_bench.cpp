// SPDX-License-Identifier: Apache-2.0

// Compares the processor times per bubble of free patches with those of tori, alternately in one
// run:
//
//     patch_bench [LARGEST]
//
// The foams have 1,000 and 10,000 bubbles, but at most LARGEST. All together take about a minute.

#include "tests/bench/bench_foams.h"

#include <fmt/core.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

namespace foam::bench {

namespace {

constexpr int kBubblesInAll = 20000;  // total number of bubbles of the raw diagrams of a row
constexpr int kFrames = 10;

struct Times {
    double raw = 0.0;    // microseconds per bubble on all threads, from the diagram to equilibrium
    double frame = 0.0;  // microseconds per bubble on all threads, mean of the first frames
};

template <class Work>
double microseconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void demand(const EquilibriumSummary& summary) {
    if (!summary.converged()) {
        throw std::runtime_error("no equilibrium");
    }
}

void add(Times& times, Foam foam, int seeds) {
    const double count = static_cast<double>(foam.network.bubble_count()) * seeds;
    times.raw += microseconds([&] { demand(equilibrate(foam, {})); }) / count;
    times.frame += microseconds([&] {
                       for (int frame = 0; frame < kFrames; ++frame) {
                           demand(step(foam, ordinary_frame_time(foam, {}), {}).equilibrium);
                       }
                   }) /
                   (count * kFrames);
}

void print_rows(int bubbles) {
    Times tori;
    Times patches;
    const int seeds = kBubblesInAll / bubbles;
    for (int k = 1; k <= seeds; ++k) {
        const auto seed = static_cast<std::uint64_t>(k);
        add(tori, seed_foam({.bubbles = bubbles, .seed = seed}), seeds);
        add(patches, raw_patch(bubbles, seed), seeds);
    }
    const auto print_row = [&](const char* work, double domain, double patch) {
        fmt::print("| {} bubbles, {} | {:.3g} | {:.3g} | {:.2f} |\n",
                   bubbles,
                   work,
                   domain,
                   patch,
                   patch / domain);
    };
    print_row("from a raw diagram", tori.raw, patches.raw);
    print_row("a frame", tori.frame, patches.frame);
    static_cast<void>(std::fflush(stdout));
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    try {
        fmt::print("| microseconds per bubble | torus | patch | ratio |\n|---|---|---|---|\n");
        const int largest = argc > 1 ? std::atoi(argv[1]) : 10000;
        for (int bubbles = 1000; bubbles <= largest; bubbles *= 10) {
            foam::bench::print_rows(bubbles);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "patch_bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
