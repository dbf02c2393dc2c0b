// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace foam {

/// A pool of threads that are kept between tasks, since starting a thread takes longer than most
/// loops of `parallel_for`. Waking a thread is also slow. An idle thread therefore first spins for
/// 50 microseconds, yielding its processor to any other thread, and then sleeps.
class WorkerPool {
  public:
    /// Returns the only pool of the program. Its threads are started when they are first needed.
    static WorkerPool& shared();

    WorkerPool() = default;
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    ~WorkerPool();

    /// Calls work() on the caller's thread and concurrently on up to `helpers` threads of the pool.
    /// Returns when all calls that have begun have returned. The caller does not wait for a helper
    /// that has not begun when the caller's own call returns. Therefore work() may itself call
    /// run(), and any number of threads may call run() at once.
    ///
    /// Throws std::system_error if a thread cannot be started. Preconditions: work() does not
    /// throw, and is correct for any number of concurrent calls, including one.
    void run(int helpers, const std::function<void()>& work);

  private:
    struct Task {
        const std::function<void()>* work = nullptr;
        int unclaimed = 0;            // helpers that may still join
        std::atomic<int> running{0};  // helpers that are inside work()
    };

    void start_threads(int count);
    void serve();
    Task* claim();
    void remove(Task& task);

    std::mutex mutex_;
    std::condition_variable changed_;   // signals a new task or the closing of the pool
    std::condition_variable finished_;  // signals that a helper has left work()
    std::vector<Task*> tasks_;
    std::atomic<std::size_t> task_count_{0};  // tasks_.size(), readable without the lock
    bool closing_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace foam
