// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace foam {

// The caller of run() adds a task to a list and works itself. Idle threads of the pool claim the
// last task of the list and call its work(). The caller removes the task when its own call has
// returned, and waits for the helpers that are still inside work(). Caller and helpers spin for a
// short time before they sleep on a condition variable.

namespace {

// About the time that it takes to put a thread to sleep and to wake it again.
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

void WorkerPool::start_threads(int count) {
    while (threads_.size() < static_cast<std::size_t>(count)) {
        threads_.emplace_back([this] { serve(); });
    }
}

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
        lock.lock();
        --task->running;
        finished_.notify_all();  // under the lock, since the task may be destroyed right after it
    }
}

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
