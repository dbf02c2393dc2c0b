// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace foam {

/// Returns the number of threads that a `threads` option or argument requests, anywhere in the
/// project: the value itself if it is positive, otherwise as many threads as the hardware runs at
/// once. The result is at least 1.
int thread_count(int threads);

/// Calls body(first, last) for each chunk of [0, count). The chunks are [0, grain), [grain, 2
/// grain) and so on; the last one ends at `count`.
///
/// Runs on up to thread_count(threads) threads including the caller's, but at most 256. Chunks run
/// in no particular order. They do not depend on the number of threads, so that a body that writes
/// only to its own range gives the same result for any number. Returns when all calls have
/// returned. If a call throws, chunks that have not begun are skipped, and the first exception is
/// rethrown. `body` may itself call parallel_for. Precondition: grain > 0.
void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

/// Calls body(k) for each k in [0, count), with the same guarantees as parallel_for over chunks of
/// one index. A negative count is an empty range.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// Calls body(worker, k) for each k in [0, count), on at most one thread per element of `workers`.
/// Each element is the state of one thread and is never used by two calls at once. Timing
/// determines which state a call gets. Precondition: `workers` is not empty.
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
