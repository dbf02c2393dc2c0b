// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/parallel_for.h"

#include "core/parallel/worker_pool.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace foam {

namespace {

// The chunks of one call of parallel_for. A thread claims the next chunk by incrementing a shared
// atomic counter.
class Chunks {
  public:
    Chunks(std::size_t count,
           std::size_t grain,
           const std::function<void(std::size_t, std::size_t)>& body)
        : items_(count), grain_(grain), body_(body) {}

    std::size_t count() const { return chunk_count(items_, grain_); }

    // Processes chunks until none is left. May be called by any number of threads at once.
    void work() {
        for (std::size_t k = next_++; k < count(); k = next_++) {
            try {
                const std::size_t first = k * grain_;
                body_(first, first + std::min(grain_, items_ - first));
            } catch (...) {
                stop(std::current_exception());
            }
        }
    }

    void rethrow() const {
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

  private:
    void stop(std::exception_ptr failure) {
        const std::scoped_lock lock(mutex_);
        if (!failure_) {
            failure_ = std::move(failure);
        }
        next_ = count();
    }

    std::size_t items_;
    std::size_t grain_;
    const std::function<void(std::size_t, std::size_t)>& body_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

int thread_count(int threads) {
    // hardware_concurrency is called only once, because it reads files of the system, which takes
    // 0.006 ms.
    static const int hardware_threads =
        std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return threads > 0 ? threads : hardware_threads;
}

void parallel_for(std::size_t count,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    assert(grain > 0);
    if (count == 0) {
        return;
    }
    Chunks chunks(count, grain, body);
    const auto allowed = static_cast<std::size_t>(std::min(thread_count(threads), kMaxThreads));
    const std::size_t used = std::min(allowed, chunks.count());
    WorkerPool::shared().run(static_cast<int>(used) - 1, [&chunks] { chunks.work(); });
    chunks.rethrow();
}

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    const auto indices = static_cast<std::size_t>(std::max(count, 0));
    parallel_for(
        indices, 1, threads, [&](std::size_t k, std::size_t) { body(static_cast<int>(k)); });
}

}  // namespace foam
