// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

namespace foam {
namespace {

TEST(WorkerPool, WithoutHelpersRunsOnceOnTheCaller) {
    WorkerPool pool;
    for (const int helpers : {0, -1}) {
        int calls = 0;
        pool.run(helpers, [&, caller = std::this_thread::get_id()] {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            ++calls;
        });
        EXPECT_EQ(calls, 1);
    }
}

// Each call waits until three calls have begun: on the caller's thread and on two helpers.
TEST(WorkerPool, RunsHelpersBesideTheCaller) {
    WorkerPool pool;
    std::set<std::thread::id> threads;
    std::mutex mutex;
    std::atomic<int> begun{0};
    pool.run(2, [&] {
        ++begun;
        while (begun < 3) {
            std::this_thread::yield();
        }
        const std::scoped_lock lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads.size(), 3U);
    EXPECT_EQ(threads.count(std::this_thread::get_id()), 1U);
}

TEST(WorkerPool, NeverRunsMoreCallsThanHelpersAndTheCaller) {
    WorkerPool pool;
    pool.run(5, [] {});  // starts five threads
    for (int repeat = 0; repeat < 100; ++repeat) {
        std::atomic<int> calls{0};
        pool.run(1, [&] { ++calls; });
        EXPECT_GE(calls, 1);
        EXPECT_LE(calls, 2);
    }
}

// The only thread of the pool is inside the outer call when the inner call requests a helper.
TEST(WorkerPool, DoesNotWaitForBusyHelpers) {
    WorkerPool pool;
    std::atomic<int> outer{0};
    std::atomic<int> inner{0};
    pool.run(1, [&] {
        ++outer;
        while (outer < 2) {
            std::this_thread::yield();
        }
        pool.run(1, [&] { ++inner; });
    });
    EXPECT_EQ(outer, 2);
    EXPECT_GE(inner, 2);
}

TEST(WorkerPool, SharedIsOnePool) {
    EXPECT_EQ(&WorkerPool::shared(), &WorkerPool::shared());
}

}  // namespace
}  // namespace foam
