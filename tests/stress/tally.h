// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/stress/life.h"
#include "tests/stress/recovery.h"

#include <cstdint>
#include <string>
#include <vector>

namespace foam::stress {

/// The largest of several values, and the seed of its foam.
struct Worst {
    double value = 0.0;
    std::uint64_t seed = 0;

    /// Replaces the value and the seed by the given ones if the given value is larger.
    void take(double other, std::uint64_t other_seed);
};

/// Sums and largest values over many foams.
struct LifeTally {
    int foams = 0;
    long frames = 0;
    long substeps = 0;
    long t1 = 0;
    long t2 = 0;
    Worst area;     // relative area error
    Worst angle;    // angle error in radians
    Worst seconds;  // processor time
    double total_seconds = 0.0;
    std::vector<std::uint64_t> failed;  // seeds of the foams that failed

    void add(std::uint64_t seed, const LifeSummary& summary);
};

/// Sums and largest values over many recoveries from ill-defined states.
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

/// Returns a report of a few lines: sums, largest values and the seeds that failed. `foams` is the
/// name of the foams in the report.
std::string describe(const LifeTally& tally, const char* foams);
/// Returns the same kind of report for recoveries.
std::string describe(const RecoveryTally& tally);

}  // namespace foam::stress
