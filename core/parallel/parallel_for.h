#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace foam {

/// Returns the number of threads that a `threads` option or argument means, anywhere in the
/// project: itself if positive, otherwise as many threads as the hardware runs at once. The result
/// is at least 1.
int thread_count(int threads);

/// Calls body(first, last) for each chunk of [0, count): [0, grain), [grain, 2 grain) and so on;
/// the last chunk is cut off at `count`.
///
/// Runs on up to thread_count(threads) threads, one of which is the caller's. The chunks do not
/// depend on the number of threads, so that a body that writes only to its own range gives the
/// same result for any number. They run in no particular order. Returns when all calls have
/// returned; if a call throws, chunks not yet begun are skipped and the first exception is
/// rethrown here. `body` may itself call parallel_for. Precondition: grain > 0.
void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

/// Calls body(k) for each k in [0, count), with the same guarantees as parallel_for over chunks of
/// one index. A negative count is an empty range.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// Calls body(worker, k) for each k in [0, count). Each element of `workers` is the state of one
/// thread, used by no two calls at once; which calls it serves depends on timing.
/// Precondition: `workers` is not empty.
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
