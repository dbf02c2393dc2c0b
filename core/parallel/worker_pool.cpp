// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace foam {

// The caller of run() puts an offer on a list and works itself. Idle threads of the pool claim the
// last offer of the list, call its work(), and report when they have left it. The caller withdraws
// the offer when its own call has returned, and waits for the helpers that are inside work().
// Caller and helpers spin for a short time before they sleep on a condition variable.

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
    Offer offer;
    offer.work = &work;
    offer.unclaimed = helpers;
    {
        const std::scoped_lock lock(mutex_);
        start_threads(helpers);
        offers_.push_back(&offer);
        offered_ = offers_.size();
    }
    for (int k = 0; k < helpers; ++k) {
        changed_.notify_one();
    }
    work();
    withdraw(offer);
    spin_until([&] { return offer.running == 0; });
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [&] { return offer.running == 0; });
}

void WorkerPool::withdraw(Offer& offer) {
    const std::scoped_lock lock(mutex_);
    offers_.erase(std::remove(offers_.begin(), offers_.end(), &offer), offers_.end());
    offered_ = offers_.size();
}

void WorkerPool::start_threads(int count) {
    while (threads_.size() < static_cast<std::size_t>(count)) {
        threads_.emplace_back([this] { serve(); });
    }
}

void WorkerPool::serve() {
    while (true) {
        spin_until([this] { return offered_ > 0; });
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closing_ || !offers_.empty(); });
        if (closing_) {
            return;
        }
        Offer* offer = claim();
        lock.unlock();
        (*offer->work)();
        lock.lock();
        --offer->running;
        finished_.notify_all();  // under the lock, since the offer may be destroyed right after it
    }
}

WorkerPool::Offer* WorkerPool::claim() {
    Offer* offer = offers_.back();
    ++offer->running;
    if (--offer->unclaimed == 0) {
        offers_.pop_back();
        offered_ = offers_.size();
    }
    return offer;
}

}  // namespace foam
