#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

class Worker {
  public:
    Worker(int count, const std::function<void(int)>& body) : count_(count), body_(body) {}

    void work() {
        for (int k = next_++; k < count_; k = next_++) {
            try {
                body_(k);
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
        next_ = count_;
    }

    int count_;
    const std::function<void(int)>& body_;
    std::atomic<int> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    Worker worker(count, body);
    {
        std::vector<std::jthread> helpers;
        for (int k = 1; k < std::min(threads, count); ++k) {
            helpers.emplace_back([&worker] { worker.work(); });
        }
        worker.work();
    }
    worker.rethrow();
}

}  // namespace foam::texgen
