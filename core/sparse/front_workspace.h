// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <cstddef>
#include <span>

namespace foam {

/// The largest number of threads that can work on different subtrees.
inline constexpr int kMaxWorkers = 16;

/// Lays out the remainders of all fronts in one workspace. A remainder is needed from the
/// elimination of its own front to that of the parent; before and after, other remainders use the
/// same memory. Sets `remainder_begin` and `may_fork` of every front. Returns the size of the
/// workspace.
std::size_t share_workspace(std::span<Front> fronts);

}  // namespace foam
