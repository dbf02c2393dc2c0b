// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/start_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <system_error>

namespace foam {
namespace {

TEST(StartThreads, StartsTheMissingThreads) {
    std::atomic<int> started{0};
    std::vector<std::jthread> threads;
    const auto start = [&] { return std::jthread([&] { ++started; }); };
    EXPECT_TRUE(start_threads_up_to(2, threads, start));
    EXPECT_TRUE(start_threads_up_to(3, threads, start));
    EXPECT_TRUE(start_threads_up_to(1, threads, start));
    EXPECT_EQ(threads.size(), 3U);
    threads.clear();  // joins
    EXPECT_EQ(started, 3);
}

// Returns a function that starts two threads and then throws the given exception.
template <class Error>
auto two_then(const Error& error) {
    return [error, left = 2]() mutable {
        if (left-- == 0) {
            throw error;
        }
        return std::jthread([] {});
    };
}

TEST(StartThreads, KeepsTheThreadsThatStarted) {
    std::vector<std::jthread> threads;
    EXPECT_FALSE(start_threads_up_to(5,
                                     threads,
                                     two_then(std::system_error(std::make_error_code(
                                         std::errc::resource_unavailable_try_again)))));
    EXPECT_EQ(threads.size(), 2U);
    EXPECT_FALSE(start_threads_up_to(6, threads, two_then(std::bad_alloc())));
    EXPECT_EQ(threads.size(), 4U);
}

}  // namespace
}  // namespace foam
