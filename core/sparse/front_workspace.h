// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <cstddef>
#include <span>

namespace foam {

/// The largest number of threads that can work on different subtrees at the same time.
inline constexpr int kMaxWorkers = 16;

/// Lays out the remainders of all fronts in one workspace. A remainder is needed only from the
/// elimination of its front until the elimination of the parent front; before and after, its memory
/// is used by other remainders. Sets `remainder_begin` and `may_fork` of every front. Returns the
/// size of the workspace.
std::size_t share_workspace(std::span<Front> fronts);

}  // namespace foam
