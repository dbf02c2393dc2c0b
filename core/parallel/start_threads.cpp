// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/start_threads.h"

#include <new>
#include <system_error>

namespace foam {

bool start_up_to(std::size_t count,
                 std::vector<std::jthread>& threads,
                 const std::function<std::jthread()>& start) {
    try {
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
