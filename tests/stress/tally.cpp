// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/tally.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace foam::stress {

namespace {

std::string describe(int count, const std::vector<std::uint64_t>& failed) {
    if (failed.empty()) {
        return fmt::format("none of {} failed", count);
    }
    return fmt::format(
        "{} of {} failed, of the seeds {}", failed.size(), count, fmt::join(failed, ", "));
}

// Returns two lines with the largest errors and times.
template <class Tally>
std::string describe_worst(const Tally& tally) {
    return fmt::format(
        "worst area error {:.1e} (seed {}), worst angle error {:.1e} (seed {})\n"
        "slowest {:.1f} s (seed {}), {:.1f} s in all\n",
        tally.area.value,
        tally.area.seed,
        tally.angle.value,
        tally.angle.seed,
        tally.seconds.value,
        tally.seconds.seed,
        tally.total_seconds);
}

template <class Tally>
void add_common(Tally& tally, std::uint64_t seed, double seconds, bool failed) {
    tally.seconds.take(seconds, seed);
    tally.total_seconds += seconds;
    if (failed) {
        tally.failed.push_back(seed);
    }
}

}  // namespace

void Worst::take(double other, std::uint64_t other_seed) {
    if (other > value) {
        *this = {other, other_seed};
    }
}

void LifeTally::add(std::uint64_t seed, const LifeSummary& summary) {
    ++foams;
    frames += summary.frames;
    substeps += summary.substeps;
    t1 += summary.t1;
    t2 += summary.t2;
    area.take(summary.worst.area, seed);
    angle.take(summary.worst.angle, seed);
    add_common(*this, seed, summary.seconds, summary.failure.has_value());
}

void RecoveryTally::add(std::uint64_t seed, const RecoverySummary& summary) {
    ++states;
    damage.films_at_limit += summary.damage.films_at_limit;
    damage.zero_films += summary.damage.zero_films;
    damage.tangled_junctions += summary.damage.tangled_junctions;
    damage.inverted_bubbles += summary.damage.inverted_bubbles;
    area.take(summary.equilibrium.area_error, seed);
    angle.take(summary.equilibrium.angle_error, seed);
    add_common(*this, seed, summary.seconds, summary.failure.has_value());
}

std::string describe(const LifeTally& tally, const char* foams) {
    return fmt::format("{}: {}\n{} frames, {} substeps, {} T1, {} T2\n{}",
                       foams,
                       describe(tally.foams, tally.failed),
                       tally.frames,
                       tally.substeps,
                       tally.t1,
                       tally.t2,
                       describe_worst(tally));
}

std::string describe(const RecoveryTally& tally) {
    return fmt::format("ill-defined states: {}\n{}\n{}",
                       describe(tally.states, tally.failed),
                       describe(tally.damage),
                       describe_worst(tally));
}

}  // namespace foam::stress
