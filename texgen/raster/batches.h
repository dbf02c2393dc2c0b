#pragma once

#include "core/parallel/parallel_for.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace foam::texgen {

/// What make(first, last) makes of pieces of [0, count) of `grain` each, the last one cut off, in
/// their order; on up to `threads` threads. A batch that is being filled lies apart from those of
/// other threads: side by side in memory, they would take each other's lines of a cache.
template <class Make>
auto make_batches(std::size_t count, std::size_t grain, int threads, const Make& make) {
    std::vector<std::invoke_result_t<Make, std::size_t, std::size_t>> batches((count + grain - 1) /
                                                                              grain);
    parallel_for(count, grain, threads, [&](std::size_t first, std::size_t last) {
        batches[first / grain] = make(first, last);
    });
    return batches;
}

}  // namespace foam::texgen
