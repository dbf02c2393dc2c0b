// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace foam {

/// Returns the results of make(first, last) for each chunk of [0, count), in the order of the
/// chunks. The chunks are the same as in parallel_for. Each result is computed in the memory of its
/// thread and then moved into the vector. Threads therefore do not write to the same cache lines
/// while they work. Preconditions: grain > 0; the type of the results has a default constructor and
/// is not bool.
template <class Make>
auto parallel_map(std::size_t count, std::size_t grain, int threads, const Make& make) {
    std::vector<std::invoke_result_t<Make, std::size_t, std::size_t>> results(
        chunk_count(count, grain));
    parallel_for(count, grain, threads, [&](std::size_t first, std::size_t last) {
        results[first / grain] = make(first, last);
    });
    return results;
}

}  // namespace foam
