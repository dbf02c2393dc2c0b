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

/// Returns the state of a seed: the torus of draw_case in equilibrium, with a kind of damage that
/// depends on the seed. For even seeds the solver relaxes first.
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

/// Returns the parameters that were drawn, in one line.
std::string describe(const StateCase& state);
/// Returns the result in one line.
std::string describe(const RecoverySummary& summary);

}  // namespace foam::stress
