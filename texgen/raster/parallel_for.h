#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace foam::texgen {

/// Calls body(k) once for every k in [0, count), on up to `threads` threads; fewer than two run it
/// on the caller's. The calls come in no certain order. Returns when all are done; if some throw,
/// calls not yet begun are left out and the first exception is thrown here.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// Calls body(first, last) for pieces of [0, count) of `grain` each, the last one cut off;
/// otherwise the same.
void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

/// The first one on one thread per worker, each with a state of its own: calls call(worker, k).
/// There is at least one worker.
template <class Worker, class Call>
void parallel_for(int count, std::vector<Worker>& workers, const Call& call) {
    std::atomic<int> next{0};
    const auto threads = static_cast<int>(workers.size());
    parallel_for(threads, threads, [&](int worker) {
        for (int k = next++; k < count; k = next++) {
            call(workers[static_cast<std::size_t>(worker)], k);
        }
    });
}

}  // namespace foam::texgen
