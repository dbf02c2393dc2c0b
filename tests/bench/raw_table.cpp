// SPDX-License-Identifier: Apache-2.0

// Prints how much processor time and memory large raw diagrams take on their way to equilibrium, as
// a Markdown table. Each foam has a process of its own, whose memory the system measures.

#include "tests/bench/bench_foams.h"

#include <boost/interprocess/anonymous_shared_memory.hpp>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::bench {

namespace {

constexpr const char* kUsage =
    R"(Usage: raw_table [--patch] [--first SEED] [--frames N] SEEDS BUBBLES...

For each number of bubbles, makes raw diagrams with the seeds SEED (1 by default) to SEED + SEEDS - 1, on a
torus or as a patch with the outline of a disc, and brings each to equilibrium in a process of its own. Prints
a row with the processor times of all threads and the peak memory. Each foam also prints a line on stderr.
With --frames, the times are instead the mean wall times of the next N coarsening frames of the foam, in
each of which the area of a bubble of five or seven sides changes by 1 % of the mean area.
)";

struct Arguments {
    bool patch = false;
    int first = 1;
    int frames = 0;  // 0: measures the way to equilibrium
    int seeds = 0;
    std::vector<int> sizes;
};

// The work of one foam: making the diagram and bringing it to equilibrium, or its next frames.
struct Work {
    double seconds = 0.0;    // processor time of all threads, or wall time of a frame
    double megabytes = 0.0;  // peak memory of the process
    bool converged = false;  // to the default tolerance, 1e-9
};

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Work measure(int bubbles, std::uint64_t seed, const Arguments& arguments) {
    const auto shared = boost::interprocess::anonymous_shared_memory(sizeof(double));
    double& frame_seconds = *static_cast<double*>(shared.get_address());
    const pid_t child = fork();
    if (child < 0) {
        throw std::runtime_error("no process can be started");
    }
    if (child == 0) {  // ends with _exit, so that it does not print the parent's buffered rows
        try {
            Foam foam = arguments.patch ? raw_patch(bubbles, seed)
                                        : seed_foam({.bubbles = bubbles, .seed = seed});
            const bool converged = equilibrate(foam, {}).converged();
            if (converged && arguments.frames > 0) {
                frame_seconds = mean_frame_seconds(foam, arguments.frames);
            }
            _exit(converged ? EXIT_SUCCESS : EXIT_FAILURE);
        } catch (const std::exception& error) {
            fmt::print(stderr, "{}\n", error.what());
            _exit(EXIT_FAILURE);
        }
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    return {.seconds = arguments.frames > 0 ? frame_seconds
                                            : seconds(usage.ru_utime) + seconds(usage.ru_stime),
            .megabytes = static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6,
            .converged = WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS};
}

void print_row(int bubbles, const Arguments& arguments) {
    std::vector<double> times;  // without those of frames that were not reached
    double memory = 0.0;
    std::size_t converged = 0;
    for (int seed = arguments.first; seed < arguments.first + arguments.seeds; ++seed) {
        const Work work = measure(bubbles, static_cast<std::uint64_t>(seed), arguments);
        fmt::print(stderr,
                   "{} bubbles, seed {}: {:.3g} s, {:.0f} MB{}\n",
                   bubbles,
                   seed,
                   work.seconds,
                   work.megabytes,
                   work.converged ? "" : ", no equilibrium");
        if (work.converged || arguments.frames == 0) {
            times.push_back(work.seconds);
        }
        memory = std::max(memory, work.megabytes);
        converged += work.converged ? 1 : 0;
    }
    if (times.empty()) {
        throw std::runtime_error(fmt::format("no foam of {} bubbles reached its frames", bubbles));
    }
    std::ranges::sort(times);
    const double median = times[times.size() / 2];
    fmt::print("| {} {} | {} of {} | {:.3g} s | {:.3g} s | {:.2f} | {:.0f} MB |\n",
               bubbles,
               arguments.patch ? "in a patch" : "on a torus",
               converged,
               arguments.seeds,
               median,
               times.back(),
               times.back() / median,
               memory);
    static_cast<void>(std::fflush(stdout));
}

int positive(const char* text) {
    const int value = std::atoi(text);
    if (value < 1) {
        throw std::invalid_argument(fmt::format("'{}' is not a positive integer", text));
    }
    return value;
}

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    int k = 1;
    for (; k < argc && std::string_view(argv[k]).starts_with("--"); ++k) {
        const std::string_view option = argv[k];
        if (option == "--patch") {
            arguments.patch = true;
        } else if (option == "--first" && k + 1 < argc) {
            arguments.first = positive(argv[++k]);
        } else if (option == "--frames" && k + 1 < argc) {
            arguments.frames = positive(argv[++k]);
        } else {
            throw std::invalid_argument(kUsage);
        }
    }
    if (argc - k < 2) {
        throw std::invalid_argument(kUsage);
    }
    arguments.seeds = positive(argv[k++]);
    for (; k < argc; ++k) {
        arguments.sizes.push_back(positive(argv[k]));
    }
    return arguments;
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    using namespace foam::bench;
    try {
        const Arguments arguments = parse(argc, argv);
        fmt::print(
            "| bubbles | equilibrium | median | worst | worst / median | peak memory |\n"
            "|---|---|---|---|---|---|\n");
        for (const int bubbles : arguments.sizes) {
            print_row(bubbles, arguments);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
