// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace foam {

/// Adds threads to `threads` until it has at least `count` elements. `start` starts one thread. It
/// throws std::system_error or std::bad_alloc if the system allows no further thread or has no
/// memory for it. In this case, this function starts no further thread and keeps those that it has
/// started. 128 MiB of address space are left free for other memory. Returns true if `threads` has
/// at least `count` elements in the end.
bool start_threads_up_to(std::size_t count,
                         std::vector<std::jthread>& threads,
                         const std::function<std::jthread()>& start);

}  // namespace foam
