// SPDX-License-Identifier: Apache-2.0

// Prints the measured times of the solver and their targets, as a Markdown table.

#include "tests/bench/bench_foams.h"
#include "tests/bench/largest_argument.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::bench {

namespace {

constexpr const char* kUsage = R"(Usage: solver_table [LARGEST]

Prints the measured times of the solver and their targets as a Markdown table. LARGEST is the largest
number of bubbles, by default 100,000; a smaller number omits the rows of 100,000 bubbles, but no
others. All together take about three minutes.
)";
constexpr int kFrames = 10;
constexpr std::size_t kFewestBubbles = 11;  // as in the paper's Figures 5 and 6

template <class Work>
double seconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void demand(const EquilibriumSummary& summary) {
    if (!summary.converged()) {
        throw std::runtime_error("no equilibrium");
    }
}

void print_row(const std::string& work, double ours, const std::string& unit, double target) {
    fmt::print("| {} | {:.3g} {} | {:g} {} |\n", work, ours, unit, target, unit);
    static_cast<void>(std::fflush(stdout));
}

// Returns the largest memory use of the process so far, in GiB.
double peak_gibibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

// Returns the mean time from a raw diagram to equilibrium over the seeds 1 to `seeds`, in seconds.
double raw_seconds(int bubbles, std::uint64_t seeds) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Foam foam = seed_foam({.bubbles = bubbles, .seed = seed});
        sum += seconds([&] { demand(equilibrate(foam, {})); });
    }
    return sum / static_cast<double>(seeds);
}

// Returns the mean time of the first frames of a foam that has just reached equilibrium, in
// seconds.
double frame_seconds(int bubbles) {
    Foam foam = raw_foam(bubbles);
    demand(equilibrate(foam, {}));
    return mean_frame_seconds(foam, kFrames);
}

// Returns the time from a raw diagram until kFewestBubbles bubbles are left, in seconds.
double life_seconds(int bubbles) {
    Foam foam = raw_foam(bubbles);
    return seconds([&] {
        demand(equilibrate(foam, {}));
        while (foam.network.bubble_count() > kFewestBubbles) {
            demand(step(foam, ordinary_frame_time(foam, {}), {}).equilibrium);
        }
    });
}

void print_table(int largest) {
    fmt::print("| work | ours | target |\n|---|---|---|\n");
    print_row("1,000 bubbles from a raw diagram, mean of 20", raw_seconds(1000, 20), "s", 0.07);
    print_row("10,000 bubbles from a raw diagram, mean of 5", raw_seconds(10000, 5), "s", 3.0);
    std::map<int, double> frames;
    for (const auto& [bubbles, target] : {std::pair{1000, 0.015}, {10000, 0.15}}) {
        frames[bubbles] = frame_seconds(bubbles);
        print_row(fmt::format("a frame of {} bubbles", bubbles), frames[bubbles], "s", target);
    }
    print_row("from 10,000 bubbles to 11, in such frames", life_seconds(10000), "s", 300.0);
    if (largest < 100000) {
        return;
    }
    print_row("100,000 bubbles from a raw diagram", raw_seconds(100000, 1), "s", 60.0);
    print_row("the same, peak memory", peak_gibibytes(), "GiB", 3.0);
    frames[100000] = frame_seconds(100000);
    print_row("a frame of 100,000 bubbles", frames[100000], "s", 0.15 * std::pow(10.0, 1.15));
    print_row("growth of a frame's cost from 1,000 to 100,000 bubbles, exponent",
              std::log10(frames[100000] / frames[1000]) / 2.0,
              "",
              1.15);
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    using namespace foam::bench;
    try {
        print_table(largest_argument(argc, argv, 100000, kUsage));
    } catch (const std::exception& error) {
        fmt::print(stderr, "solver_table: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
