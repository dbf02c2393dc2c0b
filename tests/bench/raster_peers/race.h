// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace foam::bench {

/// A piece of work whose time is compared with the times of others.
struct Contender {
    std::string name;
    std::function<void()> run;
    double seconds = 0.0;  // shortest time of all runs
};

enum class Clock {
    Processor,  // processor time, sum over all threads; other programs do not count
    Wall,       // elapsed time
};

/// Measures the times of all contenders, which take turns `rounds` times. In each turn a contender
/// makes a few consecutive runs, as for the frames of a sequence. Caches and threads are then in
/// the state in which its previous run left them. The results are in Contender::seconds.
void race(std::vector<Contender>& contenders, int rounds, Clock clock);

}  // namespace foam::bench
