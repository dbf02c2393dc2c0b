// SPDX-License-Identifier: Apache-2.0

// Prints how many cycles, and how much processor time, a boil (E9) takes to close, as a Markdown
// table.

#include "core/dynamics/cycle.h"
#include "core/foam/seeding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

namespace foam::bench {

namespace {

constexpr const char* kUsage = R"(Usage: boil_table [SEEDS [BUBBLES...]]

For each number of bubbles, by default 100, 300, 500, 1,000 and 2,000, makes foams with the seeds 1 to
SEEDS (5 by default) and lets 12 % of their bubbles boil with 48 steps a cycle until two cycles in a row close.
Times are processor times of all threads. Each foam also prints a line on stderr. All together take about
20 minutes.
)";
constexpr double kClosed = 1e-9;
constexpr int kMaxCycles = 100;
constexpr int kCloses = 2;  // number of cycles in a row that must close, as in a bake
constexpr int kSteps = 48;

// The last cycle of a boil that has closed, and the search for it.
struct ClosedBoil {
    int cycles = 0;
    double seconds = 0.0;  // processor time of all threads
    double births = 0.0;   // in the last cycle, as a fraction of the bubbles
    double t1 = 0.0;       // T1s in the last cycle per birth
};

// Makes the steps of one cycle and clears the events of earlier cycles. Returns false if a step
// finds no equilibrium.
bool make_cycle(Cycle& cycle, Foam& foam) {
    foam.events.clear();
    for (int position = 1; position <= kSteps; ++position) {
        if (!cycle.step_to(position, foam, 0.0, {}).equilibrium.converged()) {
            return false;
        }
    }
    return true;
}

double count(const Foam& foam, TopologyEventKind kind) {
    return static_cast<double>(std::ranges::count(
        foam.events, kind, [](const TopologyEvent& event) { return event.kind; }));
}

// Returns the processor time that all threads of the program have used. Other programs that run on
// the same machine hardly change it.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Returns nothing if no cycle closes.
std::optional<ClosedBoil> close_boil(int bubbles, std::uint64_t seed) {
    Foam foam = seed_foam({.bubbles = bubbles, .lloyd_iterations = 2, .seed = seed});
    const double begin = processor_seconds();
    if (!equilibrate(foam, {}).converged()) {
        return std::nullopt;
    }
    Cycle cycle(foam, {.steps = kSteps, .area_amplitude = 0.1, .boiling = 0.12, .seed = seed});
    cycle.step_to(0, foam, 0.0, {});
    int closed = 0;
    for (int cycles = 1; cycles <= kMaxCycles; ++cycles) {
        const Foam start = foam;
        if (!make_cycle(cycle, foam)) {
            return std::nullopt;
        }
        const bool closes = closing_error(start, foam) < kClosed && cycle.repeats();
        closed = closes ? closed + 1 : 0;
        if (closed == kCloses) {
            const double births = count(foam, TopologyEventKind::Birth);
            return ClosedBoil{.cycles = cycles,
                              .seconds = processor_seconds() - begin,
                              .births = births / bubbles,
                              .t1 = count(foam, TopologyEventKind::T1) / births};
        }
        if (!closes) {
            cycle.calm(foam);
        }
    }
    return std::nullopt;
}

// Returns "median / largest" of one property.
template <class Property>
std::string median_and_largest(std::vector<ClosedBoil> boils, const char* unit, Property property) {
    std::ranges::sort(boils, {}, property);
    const std::size_t middle = boils.size() / 2;
    return fmt::format("{:.3g} / {:.3g}{}",
                       static_cast<double>(boils[middle].*property),
                       static_cast<double>(boils.back().*property),
                       unit);
}

void report(int bubbles, int seed, const std::optional<ClosedBoil>& boil) {
    fmt::print(stderr, "{} bubbles, seed {}: ", bubbles, seed);
    if (boil) {
        fmt::print(stderr, "closed after {} cycles, {:.1f} s\n", boil->cycles, boil->seconds);
    } else {
        fmt::print(stderr, "not closed\n");
    }
}

void print_row(int bubbles, int seeds) {
    std::vector<ClosedBoil> boils;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto boil = close_boil(bubbles, static_cast<std::uint64_t>(seed));
        report(bubbles, seed, boil);
        if (boil) {
            boils.push_back(*boil);
        }
    }
    if (boils.empty()) {
        fmt::print("| {} | 0 of {} | | | | |\n", bubbles, seeds);
        return;
    }
    const double fewest_births = std::ranges::min(boils, {}, &ClosedBoil::births).births;
    fmt::print("| {} | {} of {} | {} | {} | {:.1f} % | {} |\n",
               bubbles,
               boils.size(),
               seeds,
               median_and_largest(boils, "", &ClosedBoil::cycles),
               median_and_largest(boils, " s", &ClosedBoil::seconds),
               100.0 * fewest_births,
               median_and_largest(boils, "", &ClosedBoil::t1));
    static_cast<void>(std::fflush(stdout));
}

int run(int argc, char** argv) {
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
    std::vector<int> sizes;
    for (int k = 2; k < argc; ++k) {
        sizes.push_back(std::atoi(argv[k]));
    }
    if (seeds < 1 || std::ranges::any_of(sizes, [](int bubbles) { return bubbles < 20; })) {
        fmt::print(stderr, "{}", kUsage);
        return EXIT_FAILURE;
    }
    fmt::print(
        "| bubbles | closed | cycles, median / largest | processor time | fewest births per bubble "
        "| T1s per birth |\n|---|---|---|---|---|---|\n");
    for (const int bubbles : sizes.empty() ? std::vector{100, 300, 500, 1000, 2000} : sizes) {
        print_row(bubbles, seeds);
    }
    return EXIT_SUCCESS;
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    return foam::bench::run(argc, argv);
}
