// SPDX-License-Identifier: Apache-2.0

#pragma once

// Used by png_bench and exr_bench: measures how long an image takes to encode, prints tables, and
// reads the command line.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <string>

namespace foam::bench {

inline constexpr int kRepeats = 7;

/// The time that an image takes to encode, and the size of the encoded file.
struct Cost {
    double milliseconds = std::numeric_limits<double>::infinity();
    std::size_t bytes = 0;
};

/// Returns the least time of kRepeats calls of `encode`, which returns the size of the file.
inline Cost min_cost(const std::function<std::size_t()>& encode) {
    using Clock = std::chrono::steady_clock;
    Cost cost;
    for (int k = 0; k < kRepeats; ++k) {
        const Clock::time_point begin = Clock::now();
        cost.bytes = encode();
        const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
        cost.milliseconds = std::min(cost.milliseconds, time.count());
    }
    return cost;
}

/// Prints the head of a table. `name` is the heading of its first column.
inline void print_head(const std::string& name) {
    fmt::print(
        "\n| {:24} | ms      | bytes     | faster | larger |\n"
        "|--------------------------|---------|-----------|--------|--------|\n",
        name);
}

/// Prints a row: a time and a size, the time of a peer divided by this time, and this size divided
/// by that of the peer.
inline void print_row(const std::string& name, const Cost& cost, const Cost& peer) {
    fmt::print("| {:24} | {:7.2f} | {:9} | {:6.2f} | {:6.3f} |\n",
               name,
               cost.milliseconds,
               cost.bytes,
               peer.milliseconds / cost.milliseconds,
               static_cast<double>(cost.bytes) / static_cast<double>(peer.bytes));
}

/// Runs a benchmark whose command line is [SIDE [BUBBLES]], with 1000 bubbles by default. Returns
/// the exit code of the program.
inline int run_encode_bench(int argc,
                            char** argv,
                            int default_side,
                            const std::function<void(int side, int bubbles)>& run) {
    try {
        run(argc > 1 ? std::atoi(argv[1]) : default_side, argc > 2 ? std::atoi(argv[2]) : 1000);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", argv[0], error.what());
        return EXIT_FAILURE;
    }
}

}  // namespace foam::bench
