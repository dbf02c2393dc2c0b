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

/// A pool of threads. A thread stays in the pool after its task, because starting a thread takes
/// longer than most calls of `parallel_for`. Waking a sleeping thread is also slow. An idle thread
/// therefore first spins for up to 50 microseconds, and then sleeps. While it spins, it yields its
/// processor to any other thread that can run.
class WorkerPool {
  public:
    /// Returns the pool that the whole program shares. Its threads are started when they are first
    /// needed.
    static WorkerPool& shared();

    WorkerPool() = default;
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;
    ~WorkerPool();

    /// Calls work() on the caller's thread and concurrently on up to `helpers` threads of the pool,
    /// which are called helpers. Returns when all calls that have begun have returned. Once the
    /// call on the caller's thread has returned, no further helper begins. The caller then waits
    /// only for helpers that are still inside work(). Therefore no deadlock can occur if work()
    /// itself calls run(), or if any number of threads call run() at once.
    ///
    /// If the system cannot start so many threads, fewer helpers join. Preconditions: work() does
    /// not throw, and is correct for any number of concurrent calls, including one.
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
    bool is_full_ = false;  // true if the system could not start another thread
    std::vector<std::jthread> threads_;
};

}  // namespace foam
