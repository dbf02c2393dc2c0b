// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/stress/foam_case.h"
#include "tests/stress/ill_defined.h"

#include <cstdint>
#include <optional>
#include <string>

namespace foam::stress {

/// An ill-defined state and the solver that recovers from it.
struct StateCase {
    FoamCase foam_case;
    Damage damage = Damage::All;
    bool relaxes_first = true;  // if false, Newton's method starts from the damaged state
};

/// Draws the state of a seed: the torus of draw_case in equilibrium, damaged. The seed also selects
/// the kind of damage; even seeds relax first.
StateCase draw_state(std::uint64_t seed);

/// The result of a recovery.
struct RecoverySummary {
    IllDefined damage;
    EquilibriumSummary equilibrium;
    double seconds = 0.0;  // processor time
    std::optional<std::string> failure;
};

/// Damages the foam and brings it back to equilibrium with errors below 1e-9.
RecoverySummary recover(const StateCase& state);

/// Return the parameters that were drawn, and the result, in one line each.
std::string describe(const StateCase& state);
std::string describe(const RecoverySummary& summary);

}  // namespace foam::stress
