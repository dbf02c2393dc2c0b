#include "core/parallel/worker_pool.h"

#include <algorithm>

namespace foam {

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
    Offer offer{&work, helpers, 0};
    {
        const std::scoped_lock lock(mutex_);
        start_threads(helpers);
        offers_.push_back(&offer);
    }
    for (int k = 0; k < helpers; ++k) {
        changed_.notify_one();
    }
    work();
    std::unique_lock lock(mutex_);
    offers_.erase(std::remove(offers_.begin(), offers_.end(), &offer), offers_.end());
    finished_.wait(lock, [&] { return offer.running == 0; });
}

void WorkerPool::start_threads(int count) {
    while (threads_.size() < static_cast<std::size_t>(count)) {
        threads_.emplace_back([this] { serve(); });
    }
}

void WorkerPool::serve() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return closing_ || !offers_.empty(); });
        if (closing_) {
            return;
        }
        Offer* offer = claim();
        lock.unlock();
        (*offer->work)();
        lock.lock();
        --offer->running;
        finished_.notify_all();
    }
}

WorkerPool::Offer* WorkerPool::claim() {
    Offer* offer = offers_.back();
    ++offer->running;
    if (--offer->unclaimed == 0) {
        offers_.pop_back();
    }
    return offer;
}

}  // namespace foam
