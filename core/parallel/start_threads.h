// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace foam {

/// Adds threads to `threads` until there are `count`. `start` starts one thread. If `start` throws,
/// because the system allows no further thread or has no memory for it, keeps the threads that were
/// started. Returns true if there are `count` threads.
bool start_up_to(std::size_t count,
                 std::vector<std::jthread>& threads,
                 const std::function<std::jthread()>& start);

}  // namespace foam
