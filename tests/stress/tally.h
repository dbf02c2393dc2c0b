// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/stress/life.h"
#include "tests/stress/recovery.h"

#include <cstdint>
#include <string>
#include <vector>

namespace foam::stress {

/// The largest of some values, and the seed it belongs to.
struct Worst {
    double value = 0.0;
    std::uint64_t seed = 0;

    void take(double other, std::uint64_t other_seed);
};

/// Sums and extremes over many foams.
struct LifeTally {
    int foams = 0;
    long frames = 0;
    long substeps = 0;
    long t1 = 0;
    long t2 = 0;
    Worst area;     // error, relative
    Worst angle;    // error, radians
    Worst seconds;  // of processor time
    double total_seconds = 0.0;
    std::vector<std::uint64_t> failed;  // seeds

    void add(std::uint64_t seed, const LifeSummary& summary);
};

/// The same over many ill-defined states.
struct RecoveryTally {
    int states = 0;
    IllDefined damage;
    Worst area;
    Worst angle;
    Worst seconds;
    double total_seconds = 0.0;
    std::vector<std::uint64_t> failed;

    void add(std::uint64_t seed, const RecoverySummary& summary);
};

/// A few lines each, the failed seeds among them; `foams` says what they are.
std::string describe(const LifeTally& tally, const char* foams);
std::string describe(const RecoveryTally& tally);

}  // namespace foam::stress
