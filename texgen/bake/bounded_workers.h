// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>
#include <vector>

namespace foam::texgen {

/// A thread pool with a bounded queue. At most two jobs per thread wait in the queue. This limits
/// the memory for the data of jobs, such as frames. If the queue is full, the caller runs a waiting
/// job itself instead of blocking; meanwhile, the other waiting jobs keep the threads busy.
class BoundedWorkers {
  public:
    /// Starts the given number of threads, or fewer if the system cannot start so many. Without
    /// threads, `submit` runs each job on the caller's thread and throws the exceptions of the job.
    explicit BoundedWorkers(int threads);

    /// Waits until the running jobs are done. Drops the waiting jobs.
    ~BoundedWorkers();

    BoundedWorkers(const BoundedWorkers&) = delete;
    BoundedWorkers& operator=(const BoundedWorkers&) = delete;

    /// Adds a job to the queue. If the queue is full, first runs waiting jobs on the caller's
    /// thread. If a job has thrown before, the queue was emptied; `submit` then rethrows the first
    /// exception and does not add the new job.
    void submit(std::function<void()> job);

    /// Waits until all jobs are done, and runs waiting jobs on the caller's thread meanwhile. If a
    /// job has thrown, rethrows the first exception.
    void finish();

  private:
    static constexpr std::size_t kMaxWaitingPerThread = 2;

    void work();
    void run_first(std::unique_lock<std::mutex>& lock);
    void run(const std::function<void()>& job);
    void rethrow_failure();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::queue<std::function<void()>> waiting_;
    std::size_t running_ = 0;
    bool closed_ = false;
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_;
};

}  // namespace foam::texgen
