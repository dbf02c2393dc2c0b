#include "core/parallel/parallel_for.h"

#include "core/parallel/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace foam {

namespace {

constexpr std::size_t kMostThreads = 256;  // whatever an option asks for

class Chunks {
  public:
    Chunks(std::size_t begin,
           std::size_t end,
           std::size_t grain,
           const std::function<void(std::size_t, std::size_t)>& body)
        : begin_(begin), end_(end), grain_(grain), body_(body) {}

    std::size_t count() const { return (end_ - begin_ + grain_ - 1) / grain_; }

    // Takes chunk after chunk until none is left. Any number of threads may.
    void work() {
        for (std::size_t k = next_++; k < count(); k = next_++) {
            try {
                const std::size_t first = begin_ + k * grain_;
                body_(first, std::min(end_, first + grain_));
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

    std::size_t begin_;
    std::size_t end_;
    std::size_t grain_;
    const std::function<void(std::size_t, std::size_t)>& body_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

int threads_meant(int threads) {
    return threads > 0 ? threads
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t begin,
                  std::size_t end,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    assert(grain > 0);
    if (begin >= end) {
        return;
    }
    Chunks chunks(begin, end, grain, body);
    const auto wanted = static_cast<std::size_t>(threads_meant(threads));
    const std::size_t used = std::min({wanted, chunks.count(), kMostThreads});
    WorkerPool::shared().run(static_cast<int>(used) - 1, [&chunks] { chunks.work(); });
    chunks.rethrow();
}

}  // namespace foam
