// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/parallel_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace foam {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

std::set<Range> chunks_of(std::size_t count, std::size_t grain, int threads) {
    std::set<Range> chunks;
    std::mutex mutex;
    parallel_for(count, grain, threads, [&](std::size_t first, std::size_t last) {
        const std::scoped_lock lock(mutex);
        EXPECT_TRUE(chunks.emplace(first, last).second);
    });
    return chunks;
}

TEST(ParallelFor, MakesTheSameChunksForAnyNumberOfThreads) {
    for (const int threads : {-1, 0, 1, 2, 3, 7}) {
        EXPECT_EQ(chunks_of(10, 4, threads), (std::set<Range>{{0, 4}, {4, 8}, {8, 10}}));
        EXPECT_EQ(chunks_of(8, 4, threads), (std::set<Range>{{0, 4}, {4, 8}}));
        EXPECT_EQ(chunks_of(1, 100, threads), (std::set<Range>{{0, 1}}));
    }
}

// The sum of an index and such a grain would exceed the largest std::size_t.
TEST(ParallelFor, AGrainMayBeTheLargestNumber) {
    constexpr std::size_t kMax = std::numeric_limits<std::size_t>::max();
    constexpr std::size_t kHalf = kMax / 2 + 1;
    EXPECT_EQ(chunks_of(10, kMax, 2), (std::set<Range>{{0, 10}}));
    EXPECT_EQ(chunks_of(kMax, kHalf, 2), (std::set<Range>{{0, kHalf}, {kHalf, kMax}}));
}

TEST(ParallelFor, VisitsEveryIndexOnceInEachOfManyCalls) {
    std::vector<std::atomic<int>> calls(1000);
    for (int repeat = 1; repeat <= 200; ++repeat) {
        parallel_for(calls.size(), 7, 3, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                ++calls[k];
            }
        });
        for (const std::atomic<int>& count : calls) {
            ASSERT_EQ(count, repeat);
        }
    }
}

TEST(ParallelFor, DoesNothingForAnEmptyRange) {
    parallel_for(0, 1, 4, [](std::size_t, std::size_t) { FAIL(); });
    parallel_for(0, 4, [](int) { FAIL(); });
    parallel_for(-3, 4, [](int) { FAIL(); });
}

// Each of the three calls waits until all three have begun, so that three threads are needed.
TEST(ParallelFor, RunsCallsAtTheSameTime) {
    std::atomic<int> begun{0};
    std::set<std::thread::id> threads;
    std::mutex mutex;
    parallel_for(3, 3, [&](int) {
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

TEST(ParallelFor, RunsOnTheCallerOnlyWithOneThread) {
    parallel_for(10, 1, [caller = std::this_thread::get_id()](int) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
    });
}

TEST(ParallelFor, RethrowsAnExceptionAndSkipsTheRest) {
    std::atomic<int> calls{0};
    const auto body = [&](int k) {
        ++calls;
        if (k == 3) {
            throw std::runtime_error("three");
        }
    };
    EXPECT_THROW(parallel_for(100, 1, body), std::runtime_error);
    EXPECT_EQ(calls, 4);
    EXPECT_THROW(parallel_for(100, 3, body), std::runtime_error);
    EXPECT_EQ(chunks_of(10, 1, 3).size(), 10U);  // the pool still works
}

TEST(ParallelFor, MayBeNested) {
    std::atomic<int> calls{0};
    parallel_for(8, 4, [&](int) { parallel_for(8, 4, [&](int) { ++calls; }); });
    EXPECT_EQ(calls, 64);
}

TEST(ParallelFor, MayBeCalledFromManyThreads) {
    std::atomic<int> calls{0};
    const auto call_often = [&calls] {
        for (int repeat = 0; repeat < 100; ++repeat) {
            parallel_for(10, 3, [&](int) { ++calls; });
        }
    };
    {
        const std::jthread first(call_often);
        const std::jthread second(call_often);
        call_often();
    }
    EXPECT_EQ(calls, 3000);
}

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const int threads : {-1, 0, 1, 2, 5}) {
        std::vector<std::atomic<int>> calls(37);
        parallel_for(37, threads, [&](int k) { ++calls[static_cast<std::size_t>(k)]; });
        for (const std::atomic<int>& count : calls) {
            EXPECT_EQ(count, 1);
        }
    }
}

TEST(ParallelFor, GivesEachWorkerToOneCallAtATime) {
    std::vector<std::atomic<bool>> busy(3);
    std::vector<std::atomic<int>> calls(5000);
    parallel_for(5000, busy, [&](std::atomic<bool>& own, int k) {
        EXPECT_FALSE(own.exchange(true));
        ++calls[static_cast<std::size_t>(k)];
        own = false;
    });
    for (const std::atomic<int>& count : calls) {
        EXPECT_EQ(count, 1);
    }
}

TEST(ParallelFor, ThreadCountResolvesNoneAndNegativeToTheHardware) {
    EXPECT_EQ(thread_count(3), 3);
    EXPECT_EQ(thread_count(0), std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
    EXPECT_EQ(thread_count(-2), thread_count(0));
}

}  // namespace
}  // namespace foam
