// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/front_plan.h"

#include <cstddef>
#include <span>

namespace foam {

/// The largest number of threads that can work on different subtrees at the same time.
inline constexpr int kMaxWorkers = 16;

/// Lays out the update matrices of all fronts in one workspace. An update matrix is needed only
/// from the assembly of its front until it has been added to the parent front. Before and after
/// this time, other update matrices can use the same memory. Sets `update_begin` and `may_fork` of
/// every front. Returns the size of the workspace, in floating-point numbers. Precondition: there
/// is at least one front.
std::size_t share_workspace(std::span<Front> fronts);

}  // namespace foam
