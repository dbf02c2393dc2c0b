// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bounded_workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>

namespace foam::texgen {

namespace {

class BoundedWorkersTest : public testing::TestWithParam<int> {};

TEST_P(BoundedWorkersTest, RunsEveryJobOnce) {
    std::atomic<int> sum{0};
    BoundedWorkers workers(GetParam());
    for (int k = 1; k <= 100; ++k) {
        workers.submit([&sum, k] { sum += k; });
    }
    workers.finish();
    EXPECT_EQ(sum, 5050);
}

TEST_P(BoundedWorkersTest, HandsTheFirstFailureToTheCaller) {
    BoundedWorkers workers(GetParam());
    const auto run = [&] {
        workers.submit([] { throw std::runtime_error("full disk"); });
        workers.finish();
    };
    EXPECT_THROW(run(), std::runtime_error);
}

TEST_P(BoundedWorkersTest, FinishesTwice) {
    std::atomic<int> done{0};
    BoundedWorkers workers(GetParam());
    workers.submit([&done] { ++done; });
    workers.finish();
    workers.submit([&done] { ++done; });
    workers.finish();
    EXPECT_EQ(done, 2);
}

INSTANTIATE_TEST_SUITE_P(Threads, BoundedWorkersTest, testing::Values(0, 1, 2, 5));

TEST(BoundedWorkers, HoldsNoMoreJobsThanItsThreadsRunAndAwait) {
    constexpr int kThreads = 2;
    std::atomic<int> alive{0};
    std::atomic<int> max_alive{0};
    struct Load {
        std::atomic<int>& alive;
        explicit Load(std::atomic<int>& counter) : alive(counter) { ++alive; }
        ~Load() { --alive; }
        Load(const Load&) = delete;
        Load& operator=(const Load&) = delete;
    };
    BoundedWorkers workers(kThreads);
    for (int k = 0; k < 50; ++k) {
        const auto load = std::make_shared<Load>(alive);
        workers.submit([load, &alive, &max_alive] {
            int seen = max_alive;
            while (seen < alive && !max_alive.compare_exchange_weak(seen, alive)) {
            }
        });
    }
    workers.finish();
    // The threads run kThreads jobs, twice as many wait, and the caller holds one more.
    EXPECT_LE(max_alive, 3 * kThreads + 1);
    EXPECT_GT(max_alive, 0);
}

// If the caller only waited until the queue has room, the one thread would wait for the caller
// forever.
TEST(BoundedWorkers, TheCallerWorksToo) {
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> helped{false};
    BoundedWorkers workers(1);
    for (int k = 0; k < 4; ++k) {
        workers.submit([&] {
            if (std::this_thread::get_id() == caller) {
                helped = true;
                helped.notify_all();
            } else {
                helped.wait(false);
            }
        });
    }
    workers.finish();
    EXPECT_TRUE(helped);
}

}  // namespace

}  // namespace foam::texgen
