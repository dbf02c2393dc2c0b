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

/// Runs all in turn, `rounds` times over, after once to warm up.
void race(std::vector<Contender>& contenders, int rounds, Clock clock);

}  // namespace foam::bench
