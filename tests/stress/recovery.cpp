// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/recovery.h"

#include "tests/stress/soundness.h"

#include <fmt/format.h>

#include <ctime>
#include <exception>

namespace foam::stress {

namespace {

constexpr double kTolerance = 1e-9;  // largest relative area error and angle error (radians)

void damage_and_recover(const StateCase& state, RecoverySummary& summary) {
    EquilibriumOptions options = state.foam_case.step.equilibrium;
    Foam foam = seed_foam(state.foam_case.seeding);
    if (!equilibrate(foam, options).converged()) {
        summary.failure = "no equilibrium to damage";
        return;
    }
    Random random(~state.foam_case.seeding.seed);
    apply(state.damage, foam, random);
    summary.damage = count_ill_defined(foam);
    options.relaxes_first = state.relaxes_first;
    options.tolerance = kTolerance;
    summary.equilibrium = equilibrate(foam, options);
    summary.failure = find_unsoundness(foam, kTolerance);
    if (!summary.equilibrium.converged()) {
        summary.failure = fmt::format("no equilibrium: {}, {}",
                                      name_of(summary.equilibrium.status),
                                      summary.failure.value_or("yet sound"));
    }
}

}  // namespace

StateCase draw_state(std::uint64_t seed) {
    const auto damage = static_cast<Damage>(seed / 2 % kDamages);
    return {draw_case(seed), damage, seed % 2 == 0};
}

RecoverySummary recover(const StateCase& state) {
    RecoverySummary summary;
    const std::clock_t start = std::clock();
    try {
        damage_and_recover(state, summary);
    } catch (const std::exception& error) {
        summary.failure = fmt::format("exception: {}", error.what());
    }
    summary.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return summary;
}

std::string describe(const StateCase& state) {
    return fmt::format("{}, {}, {}",
                       describe(state.foam_case),
                       name_of(state.damage),
                       state.relaxes_first ? "relaxed first" : "not relaxed first");
}

std::string describe(const RecoverySummary& summary) {
    const EquilibriumSummary& equilibrium = summary.equilibrium;
    return fmt::format(
        "{}; {}; {} iterations, {} sweeps, {} T1, area {:.1e}, angle {:.1e}, {:.1f} s",
        summary.failure ? fmt::format("FAILED: {}", *summary.failure) : "recovered",
        describe(summary.damage),
        equilibrium.iterations,
        equilibrium.sweeps,
        equilibrium.t1,
        equilibrium.area_error,
        equilibrium.angle_error,
        summary.seconds);
}

}  // namespace foam::stress
