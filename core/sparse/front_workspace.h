#pragma once

#include "core/sparse/front_plan.h"

#include <cstddef>
#include <span>

namespace foam {

/// So many threads can be busy with different subtrees.
inline constexpr int kMostThreads = 16;

/// Lays out the remainders of all fronts, each of which lives from its own front to the parent's,
/// so that they share as little memory as they need. Sets `remainder_begin` and `may_fork` of every
/// front and returns the size of the workspace.
std::size_t share_workspace(std::span<Front> fronts);

}  // namespace foam
