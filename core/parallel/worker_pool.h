#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace foam {

/// Threads that wait for work and stay for the next: starting one takes longer than most of what
/// `parallel_for` hands out. As waking one takes long, too, they look around for a moment before
/// they sleep; meanwhile any other thread may have their processor.
class WorkerPool {
  public:
    /// The one pool of the program. Its threads are started when first asked for.
    static WorkerPool& shared();

    WorkerPool() = default;
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    ~WorkerPool();

    /// Calls work() on the caller's thread and at the same time on up to `helpers` others; returns
    /// when all these calls have. A helper that is still busy elsewhere when the caller's call
    /// returns is not waited for: so work() may itself run work here, and any number of threads may
    /// call at once. Precondition: work() does not throw, and may be called any number of times
    /// from once on. Throws std::system_error where a thread cannot be started.
    void run(int helpers, const std::function<void()>& work);

  private:
    struct Offer {
        const std::function<void()>* work = nullptr;
        int unclaimed = 0;            // helpers that may still join
        std::atomic<int> running{0};  // helpers that have, and have not come back
    };

    void start_threads(int count);
    void serve();
    Offer* claim();
    void withdraw(Offer& offer);

    std::mutex mutex_;
    std::condition_variable changed_;   // an offer, or the end
    std::condition_variable finished_;  // a helper has come back
    std::vector<Offer*> offers_;
    std::atomic<std::size_t> offered_{0};  // how many offers there are, to look at without waiting
    bool closing_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace foam
