#include "core/parallel/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace foam {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

std::set<Range> chunks_of(std::size_t begin, std::size_t end, std::size_t grain, int threads) {
    std::set<Range> chunks;
    std::mutex mutex;
    parallel_for(begin, end, grain, threads, [&](std::size_t first, std::size_t last) {
        const std::scoped_lock lock(mutex);
        EXPECT_TRUE(chunks.emplace(first, last).second);
    });
    return chunks;
}

TEST(ParallelFor, CutsTheSameChunksForAnyNumberOfThreads) {
    for (const int threads : {-1, 0, 1, 2, 3, 7}) {
        EXPECT_EQ(chunks_of(3, 13, 4, threads), (std::set<Range>{{3, 7}, {7, 11}, {11, 13}}));
        EXPECT_EQ(chunks_of(0, 8, 4, threads), (std::set<Range>{{0, 4}, {4, 8}}));
        EXPECT_EQ(chunks_of(5, 6, 100, threads), (std::set<Range>{{5, 6}}));
    }
}

TEST(ParallelFor, CallsEveryIndexOnceHoweverManyCallsThereAre) {
    std::vector<std::atomic<int>> calls(1000);
    for (int repeat = 1; repeat <= 200; ++repeat) {
        parallel_for(0, calls.size(), 7, 3, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                ++calls[k];
            }
        });
        for (const std::atomic<int>& count : calls) {
            ASSERT_EQ(count, repeat);
        }
    }
}

TEST(ParallelFor, DoesNothingForNothing) {
    const auto fail = [](std::size_t, std::size_t) { FAIL(); };
    parallel_for(4, 4, 1, 4, fail);
    parallel_for(5, 4, 1, 4, fail);
}

// Each of three chunks waits for the others, which takes three threads.
TEST(ParallelFor, RunsChunksAtTheSameTime) {
    std::atomic<int> begun{0};
    std::set<std::thread::id> threads;
    std::mutex mutex;
    parallel_for(0, 3, 1, 3, [&](std::size_t, std::size_t) {
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

TEST(ParallelFor, RunsOnTheCallerAloneWithOneThread) {
    parallel_for(0, 10, 1, 1, [caller = std::this_thread::get_id()](std::size_t, std::size_t) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
    });
}

TEST(ParallelFor, PassesAnExceptionOnAndLeavesTheRestOut) {
    std::atomic<int> calls{0};
    const auto body = [&](std::size_t first, std::size_t) {
        ++calls;
        if (first == 3) {
            throw std::runtime_error("three");
        }
    };
    EXPECT_THROW(parallel_for(0, 100, 1, 1, body), std::runtime_error);
    EXPECT_EQ(calls, 4);
    EXPECT_THROW(parallel_for(0, 100, 1, 3, body), std::runtime_error);
    EXPECT_EQ(chunks_of(0, 10, 1, 3).size(), 10U);  // the threads are as good as before
}

TEST(ParallelFor, MayBeNested) {
    std::atomic<int> calls{0};
    parallel_for(0, 8, 1, 4, [&](std::size_t, std::size_t) {
        parallel_for(0, 8, 1, 4, [&](std::size_t, std::size_t) { ++calls; });
    });
    EXPECT_EQ(calls, 64);
}

TEST(ParallelFor, MayBeCalledFromManyThreads) {
    std::atomic<int> calls{0};
    const auto call_often = [&calls] {
        for (int repeat = 0; repeat < 100; ++repeat) {
            parallel_for(0, 10, 1, 3, [&](std::size_t, std::size_t) { ++calls; });
        }
    };
    {
        const std::jthread first(call_often);
        const std::jthread second(call_often);
        call_often();
    }
    EXPECT_EQ(calls, 3000);
}

TEST(ParallelFor, ThreadsMeantIsAtLeastOne) {
    EXPECT_EQ(threads_meant(3), 3);
    EXPECT_GE(threads_meant(0), 1);
    EXPECT_EQ(threads_meant(-2), threads_meant(0));
}

}  // namespace
}  // namespace foam
