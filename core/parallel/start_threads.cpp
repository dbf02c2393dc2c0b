// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/start_threads.h"

#include <cstddef>
#include <memory>
#include <new>
#include <system_error>

namespace foam {

namespace {

// The stacks of threads may use up the address space of a process. This number of bytes is kept
// free for all other memory.
constexpr std::size_t kReserve = std::size_t{1} << 27;

}  // namespace

bool start_threads_up_to(std::size_t count,
                         std::vector<std::jthread>& threads,
                         const std::function<std::jthread()>& start) {
    if (threads.size() >= count) {
        return true;
    }
    try {
        const auto reserve = std::make_unique_for_overwrite<std::byte[]>(kReserve);
        // This variable is volatile so that the compiler does not leave out the allocation, whose
        // memory is not used.
        [[maybe_unused]] const std::byte* volatile used = reserve.get();
        threads.reserve(count);
        while (threads.size() < count) {
            threads.push_back(start());
        }
        return true;
    } catch (const std::system_error&) {
        return false;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

}  // namespace foam
