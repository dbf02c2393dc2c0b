// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace foam {

/// The largest number of threads of a parallel loop, and the largest value of the option
/// `--threads` and of the arguments `threads` of the installed libraries.
inline constexpr int kMaxThreads = 256;

/// Returns the number of threads that `threads` requests: the value itself if it is positive,
/// otherwise the number of threads that the hardware runs at once. The result is at least 1. Every
/// `threads` option has this meaning. Every argument `threads` of type int has it too, unless the
/// documentation of the function says otherwise.
int thread_count(int threads);

/// Returns the number of chunks into which parallel_for divides `count` indices. Precondition:
/// grain > 0.
constexpr std::size_t chunk_count(std::size_t count, std::size_t grain) {
    return count / grain + (count % grain == 0 ? 0 : 1);
}

/// Calls body(first, last) for each chunk of [0, count). The chunks are [0, grain),
/// [grain, 2 * grain) and so on; the last one ends at `count`.
///
/// The calls are made on the caller's thread and on further threads. The total number of threads is
/// at most thread_count(threads), and at most kMaxThreads. Chunks run in no particular order. The
/// division into chunks does not depend on the number of threads. So a body that writes only to the
/// elements of its own chunk gives the same result for any number of threads. Returns when all
/// calls of `body` have returned. If a call throws, chunks that have not begun are skipped, and the
/// first exception is rethrown to the caller. `body` may itself call parallel_for. Precondition:
/// grain > 0.
void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

/// Calls body(k) for each k in [0, count), with the same guarantees as parallel_for above with a
/// grain of 1. A negative count is an empty range.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// Calls body(worker, k) for each k in [0, count), on at most one thread per element of `workers`.
/// `worker` is an element of `workers`: the state of one thread, which no other call uses at the
/// same time. Which element a call gets depends on timing. If a call throws, the first exception is
/// rethrown to the caller; whether the remaining calls are made is unspecified. Precondition:
/// `workers` is not empty.
template <class Worker, class Body>
void parallel_for(int count, std::vector<Worker>& workers, const Body& body) {
    std::atomic<int> next{0};
    const auto threads = static_cast<int>(workers.size());
    parallel_for(threads, threads, [&](int worker) {
        for (int k = next++; k < count; k = next++) {
            body(workers[static_cast<std::size_t>(worker)], k);
        }
    });
}

}  // namespace foam
