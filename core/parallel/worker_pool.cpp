// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/worker_pool.h"

#include "core/parallel/start_threads.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace foam {

// The caller of run() adds a task to a list and also calls work() itself. Idle threads of the pool
// claim the last task of the list and call the work() of this task. When the caller's own call has
// returned, the caller removes the task from the list and waits for the helpers that are still
// inside work(). Caller and helpers spin for a short time before they sleep on a condition
// variable.

namespace {

// The time for which a thread spins before it sleeps: about as long as it takes to put a thread to
// sleep and to wake it again.
constexpr std::chrono::microseconds kSpinTime{50};

// Spins until the condition is true or kSpinTime is over.
template <class Condition>
void spin_until(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + kSpinTime;
    while (!condition() && std::chrono::steady_clock::now() < end) {
        std::this_thread::yield();
    }
}

}  // namespace

WorkerPool& WorkerPool::shared() {
    static WorkerPool pool;
    return pool;
}

WorkerPool::~WorkerPool() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
}

void WorkerPool::run(int helpers, const std::function<void()>& work) {
    if (helpers <= 0) {
        work();
        return;
    }
    Task task;
    task.work = &work;
    task.unclaimed = helpers;
    {
        const std::scoped_lock lock(mutex_);
        start_threads(helpers);
        tasks_.push_back(&task);
        task_count_ = tasks_.size();
    }
    for (int k = 0; k < helpers; ++k) {
        changed_.notify_one();
    }
    work();
    remove(task);
    spin_until([&] { return task.running == 0; });
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [&] { return task.running == 0; });
}

void WorkerPool::remove(Task& task) {
    const std::scoped_lock lock(mutex_);
    tasks_.erase(std::remove(tasks_.begin(), tasks_.end(), &task), tasks_.end());
    task_count_ = tasks_.size();
}

// Starts threads until the pool has at least `count` threads. If the system cannot start a thread,
// the pool keeps the threads that it has, and never tries again. Precondition: mutex_ is locked.
void WorkerPool::start_threads(int count) {
    if (!is_full_) {
        is_full_ = !start_threads_up_to(static_cast<std::size_t>(count), threads_, [this] {
            return std::jthread([this] { serve(); });
        });
    }
}

// Runs on every thread of the pool: waits for tasks and helps with them until the pool closes.
void WorkerPool::serve() {
    while (true) {
        spin_until([this] { return task_count_ > 0; });
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
        if (closing_) {
            return;
        }
        Task* task = claim();
        lock.unlock();
        (*task->work)();
        // `running` changes under the lock, so that run() cannot miss the notification between its
        // test of `running` and its sleep. As soon as the lock is released, run() may return and
        // destroy the task.
        lock.lock();
        --task->running;
        finished_.notify_all();
    }
}

// Joins the last task of the list as a helper and returns it. Removes the task from the list if no
// further helper may join. Precondition: mutex_ is locked and the list is not empty.
WorkerPool::Task* WorkerPool::claim() {
    Task* task = tasks_.back();
    ++task->running;
    if (--task->unclaimed == 0) {
        tasks_.pop_back();
        task_count_ = tasks_.size();
    }
    return task;
}

}  // namespace foam
