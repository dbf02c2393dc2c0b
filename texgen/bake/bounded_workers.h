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

/// Threads that work off jobs beside the caller's thread. No more than two jobs wait for each of
/// them, so that what the jobs hold, such as frames, stays bounded; the caller lends a hand rather
/// than wait for room, and leaves jobs for the threads to go on with meanwhile.
class BoundedWorkers {
  public:
    /// With no threads, every job runs at once on the caller's.
    explicit BoundedWorkers(int threads);

    /// Stops after the jobs that run; those that wait are dropped.
    ~BoundedWorkers();

    BoundedWorkers(const BoundedWorkers&) = delete;
    BoundedWorkers& operator=(const BoundedWorkers&) = delete;

    /// Hands in a job. Where as many wait as may, the first of them runs on the caller's thread, to
    /// make room. Throws the first exception that an earlier job threw;
    /// later jobs are then dropped.
    void submit(std::function<void()> job);

    /// Works until no job waits, and waits until all are done. Throws as submit does.
    void finish();

  private:
    static constexpr std::size_t kWaitingPerThread = 2;

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
