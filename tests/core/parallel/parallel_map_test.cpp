// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/parallel_map.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace foam {
namespace {

TEST(ParallelMap, ReturnsTheResultsInTheOrderOfTheChunks) {
    using Range = std::pair<std::size_t, std::size_t>;
    const auto make = [](std::size_t first, std::size_t last) { return Range(first, last); };
    for (const int threads : {1, 3}) {
        const std::vector<Range> ranges = parallel_map(10, 4, threads, make);
        EXPECT_EQ(ranges, (std::vector<Range>{{0, 4}, {4, 8}, {8, 10}}));
        EXPECT_TRUE(parallel_map(0, 4, threads, make).empty());
        EXPECT_EQ(parallel_map(10, std::numeric_limits<std::size_t>::max(), threads, make),
                  (std::vector<Range>{{0, 10}}));
    }
}

}  // namespace
}  // namespace foam
