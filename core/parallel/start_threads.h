// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace foam {

/// Adds threads to `threads` until there are at least `count`. `start` starts one thread. If it
/// throws std::system_error or std::bad_alloc, because the system allows no further thread or has
/// no memory for it, keeps the threads that were started. Returns true if there are then at least
/// `count` threads.
bool start_up_to(std::size_t count,
                 std::vector<std::jthread>& threads,
                 const std::function<std::jthread()>& start);

}  // namespace foam
