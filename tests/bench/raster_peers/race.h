// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace foam::bench {

/// One way to do a piece of work.
struct Contender {
    std::string name;
    std::function<void()> run;
    double seconds = 0.0;  // the least of all runs
};

enum class Clock {
    Processor,  // what other programs take of the machine does not count; of all threads in sum
    Wall,
};

/// Lets all take turns, `rounds` times over: each has a few runs in a row, as frames of a sequence
/// have, so that caches and threads are as its own last run left them.
void race(std::vector<Contender>& contenders, int rounds, Clock clock);

}  // namespace foam::bench
