// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/stress/foam_case.h"
#include "tests/stress/ill_defined.h"

#include <cstdint>
#include <optional>
#include <string>

namespace foam::stress {

/// An ill-defined state and the way out of it.
struct StateCase {
    FoamCase foam_case;
    Damage damage = Damage::All;
    bool relaxes_first = true;  // else Newton's method meets the state as it is
};

/// The state of a seed: the foam of that seed in equilibrium, damaged in one of all ways.
StateCase draw_state(std::uint64_t seed);

struct RecoverySummary {
    IllDefined damage;
    EquilibriumSummary equilibrium;
    double seconds = 0.0;  // of processor time
    std::optional<std::string> failure;
};

/// Damages the foam and brings it back to equilibrium, to 1e-9.
RecoverySummary recover(const StateCase& state);

/// What was drawn, and what became of it, each on a line.
std::string describe(const StateCase& state);
std::string describe(const RecoverySummary& summary);

}  // namespace foam::stress
