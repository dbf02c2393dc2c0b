// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bounded_workers.h"

#include "core/parallel/start_threads.h"

#include <algorithm>
#include <utility>

// A queue with one mutex and one condition variable. Every new job and every finished job wakes all
// threads that wait for a job, and the caller if it waits in `finish` for the last job. Waking
// threads is cheap compared with a job, which draws a frame. The mutex is not locked while a job
// runs. If a job throws, the queue is cleared, and the first exception is kept for the caller.

namespace foam::texgen {

BoundedWorkers::BoundedWorkers(int threads) {
    start_threads_up_to(static_cast<std::size_t>(std::max(threads, 0)), threads_, [this] {
        return std::jthread([this] { work(); });
    });
}

BoundedWorkers::~BoundedWorkers() {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        waiting_ = {};
    }
    changed_.notify_all();
}

void BoundedWorkers::submit(std::function<void()> job) {
    if (threads_.empty()) {
        job();
        return;
    }
    std::unique_lock lock(mutex_);
    while (waiting_.size() >= kMaxWaitingPerThread * threads_.size()) {
        run_first(lock);
    }
    rethrow_failure();
    waiting_.push(std::move(job));
    changed_.notify_all();
}

void BoundedWorkers::finish() {
    std::unique_lock lock(mutex_);
    while (!waiting_.empty()) {
        run_first(lock);
    }
    changed_.wait(lock, [this] { return running_ == 0; });
    rethrow_failure();
}

void BoundedWorkers::rethrow_failure() {
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void BoundedWorkers::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
        if (waiting_.empty()) {
            return;
        }
        run_first(lock);
    }
}

void BoundedWorkers::run_first(std::unique_lock<std::mutex>& lock) {
    const std::function<void()> job = std::move(waiting_.front());
    waiting_.pop();
    ++running_;
    lock.unlock();
    run(job);
    lock.lock();
    --running_;
    changed_.notify_all();
}

void BoundedWorkers::run(const std::function<void()>& job) {
    try {
        job();
    } catch (...) {
        const std::scoped_lock lock(mutex_);
        if (!failure_) {
            failure_ = std::current_exception();
        }
        waiting_ = {};
    }
}

}  // namespace foam::texgen
