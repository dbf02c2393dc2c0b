#include "texgen/raster/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const int threads : {-1, 1, 2, 5}) {
        std::vector<std::atomic<int>> calls(37);
        parallel_for(37, threads, [&](int k) { ++calls[static_cast<std::size_t>(k)]; });
        for (const std::atomic<int>& count : calls) {
            EXPECT_EQ(count, 1);
        }
    }
}

TEST(ParallelFor, DoesNothingForNothing) {
    parallel_for(0, 4, [](int) { FAIL(); });
}

TEST(ParallelFor, PassesAnExceptionOn) {
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
}

}  // namespace
}  // namespace foam::texgen
