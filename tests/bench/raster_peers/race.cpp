// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/raster_peers/race.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace foam::bench {

namespace {

constexpr int kRunsPerRound = 4;

double now(Clock clock) {
    if (clock == Clock::Processor) {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }
    const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since_start).count();
}

}  // namespace

void race(std::vector<Contender>& contenders, int rounds, Clock clock) {
    for (Contender& contender : contenders) {
        contender.seconds = std::numeric_limits<double>::infinity();
    }
    for (int round = 0; round < rounds; ++round) {
        for (Contender& contender : contenders) {
            for (int run = 0; run < kRunsPerRound; ++run) {
                const double begin = now(clock);
                contender.run();
                contender.seconds = std::min(contender.seconds, now(clock) - begin);
            }
        }
    }
}

}  // namespace foam::bench
