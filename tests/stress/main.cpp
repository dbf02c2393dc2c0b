// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/tally.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace foam::stress {

namespace {

constexpr const char* kDescription =
    "Random foams over the ranges of the paper, tori and free patches, each from a raw diagram to "
    "its end, and random ill-defined states, each brought back to equilibrium. A seed stands for "
    "the same torus, patch or state in every run.";
constexpr const char* kFooter = R"(Examples:
  foam_stress                                  300 tori, 100 patches, 100 states
  foam_stress --max-bubbles 300 --shard 2/4    every fourth foam of 20 to 300 bubbles
  foam_stress --only 17 -v                     the torus of seed 17, frame by frame
  foam_stress --only-patch 17 -v               the patch of seed 17
  foam_stress --only-state 27 37               the states of seeds 27 and 37
Exit codes: 0 none failed, 1 some failed, other codes: bad command line)";

/// The part of the cases that this run computes: the k-th of every `count` cases.
struct Shard {
    int k = 1;
    int count = 1;

    bool takes(int index) const { return index % count == k - 1; }
};

struct Arguments {
    int foams = 300;
    int patches = 100;
    int states = 100;
    std::uint64_t first = 1;
    std::string shard = "1/1";
    int max_bubbles = 5000;
    std::vector<std::uint64_t> only;
    std::vector<std::uint64_t> only_patches;
    std::vector<std::uint64_t> only_states;
    LifeOptions life;
};

/// Parses a text I/N. Precondition: check_shard accepts the text.
Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    return {std::stoi(text.substr(0, slash)), std::stoi(text.substr(slash + 1))};
}

/// Returns an error message, or an empty text if the text is I/N with 1 <= I <= N.
std::string check_shard(const std::string& text) {
    int k = 0;
    int count = 0;
    char rest = 0;
    const bool is_pair = std::sscanf(text.c_str(), "%5d/%5d%c", &k, &count, &rest) == 2;
    return is_pair && k >= 1 && k <= count ? "" : "must be I/N with 1 <= I <= N";
}

/// Returns the first seed, at or after the given one, whose foam has at most `max_bubbles` bubbles.
std::uint64_t next_seed(std::uint64_t seed, int max_bubbles) {
    while (draw_case(seed).seeding.bubbles > max_bubbles) {
        ++seed;
    }
    return seed;
}

/// Returns the seeds of the shard, out of the first `count` seeds whose foams are small enough.
std::vector<std::uint64_t> shard_seeds(const Arguments& arguments, int count) {
    const Shard shard = parse_shard(arguments.shard);
    std::vector<std::uint64_t> seeds;
    std::uint64_t seed = arguments.first;
    for (int index = 0; index < count; ++index, ++seed) {
        seed = next_seed(seed, arguments.max_bubbles);
        if (shard.takes(index)) {
            seeds.push_back(seed);
        }
    }
    return seeds;
}

/// Prints a text followed by `end`, and flushes the output. The parameters of a foam are printed
/// before its life, so that they are known if the program crashes.
void print_part(const std::string& part, const char* end) {
    fmt::print("{}{}", part, end);
    std::fflush(stdout);
}

void run_life(const FoamCase& foam_case, const LifeOptions& options, LifeTally& tally) {
    print_part(describe(foam_case), options.verbose ? "\n" : " -> ");
    const LifeSummary summary = live(foam_case, options);
    tally.add(foam_case.seeding.seed, summary);
    print_part(describe(summary), "\n");
}

void run_recovery(std::uint64_t seed, RecoveryTally& tally) {
    const StateCase state = draw_state(seed);
    print_part(describe(state), " -> ");
    const RecoverySummary summary = recover(state);
    tally.add(seed, summary);
    print_part(describe(summary), "\n");
}

/// Chooses the seeds of the shard, unless --only, --only-patch or --only-state gives seeds.
void choose_seeds(Arguments& arguments) {
    if (arguments.only.empty() && arguments.only_patches.empty() && arguments.only_states.empty()) {
        arguments.only = shard_seeds(arguments, arguments.foams);
        arguments.only_patches = shard_seeds(arguments, arguments.patches);
        arguments.only_states = shard_seeds(arguments, arguments.states);
    }
}

int run(const Arguments& arguments) {
    LifeTally lives;
    for (const std::uint64_t seed : arguments.only) {
        run_life(draw_case(seed), arguments.life, lives);
    }
    LifeTally patches;
    for (const std::uint64_t seed : arguments.only_patches) {
        run_life(draw_patch(seed), arguments.life, patches);
    }
    RecoveryTally recoveries;
    for (const std::uint64_t seed : arguments.only_states) {
        run_recovery(seed, recoveries);
    }
    if (lives.foams > 0) {
        fmt::print("{}", describe(lives, "foams"));
    }
    if (patches.foams > 0) {
        fmt::print("{}", describe(patches, "patches"));
    }
    if (recoveries.states > 0) {
        fmt::print("{}", describe(recoveries));
    }
    const bool none_failed =
        lives.failed.empty() && patches.failed.empty() && recoveries.failed.empty();
    return none_failed ? 0 : 1;
}

void add_options(CLI::App& app, Arguments& arguments) {
    app.add_option("--foams", arguments.foams, "Tori to let coarsen")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--patches", arguments.patches, "Free patches to let coarsen")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--states", arguments.states, "Ill-defined states to recover from")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--first", arguments.first, "The seed to begin with");
    app.add_option("--shard", arguments.shard, "Runs the I-th of every N cases: I/N")
        ->check(CLI::Validator(check_shard, "I/N"));
    app.add_option("--max-bubbles", arguments.max_bubbles, "Passes over seeds of larger foams")
        ->check(CLI::Range(50, 5000));
    app.add_option("--frames", arguments.life.max_frames, "Ends each life early; 0 does not")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--tolerance", arguments.life.tolerance, "Largest error of a frame")
        ->check(CLI::PositiveNumber);
    app.add_option("--only", arguments.only, "Runs the tori of these seeds alone");
    app.add_option("--only-patch", arguments.only_patches, "Runs the patches of these seeds alone");
    app.add_option("--only-state", arguments.only_states, "Runs the states of these seeds alone");
    app.add_flag("-v,--verbose", arguments.life.verbose, "A line per frame on stderr");
}

int parse_and_run(int argc, char** argv) {
    CLI::App app(kDescription, "foam_stress");
    Arguments arguments;
    add_options(app, arguments);
    app.footer(kFooter);
    CLI11_PARSE(app, argc, argv);
    choose_seeds(arguments);
    return run(arguments);
}

}  // namespace

}  // namespace foam::stress

int main(int argc, char** argv) {
    try {
        return foam::stress::parse_and_run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "foam_stress: %s\n", error.what());
        return 1;
    }
}
