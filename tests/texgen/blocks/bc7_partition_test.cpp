// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_partition.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen::bc7 {
namespace {

using Simd = LanesAt<SimdLevel::Baseline>;

// Returns the partition with the smallest distances from the lines of its subsets, in the first
// lane.
template <std::size_t kSubsets>
int best_partition(const ColorLanes<Simd, 3>& colors) {
    BestPartitions<Simd> best(1);
    for_partitions<Simd, kSubsets, 3>(
        relative<Simd, 3>(colors),
        [&](int partition, const Spread<Simd>& spread) { best.insert(spread.across, partition); });
    return best.partitions[0].lanes[0];
}

// For each partition, colors of the subsets on lines that do not meet. Every texel has a color of
// its own, so every other partition mixes colors that are not on a line.
TEST(Bc7Partition, FindsThePartitionOfTheColors) {
    for (int partition = 0; partition < kPartitions; ++partition) {
        ColorLanes<Simd, 3> colors;
        for (int k = 0; k < kBlockTexels; ++k) {
            const auto step = static_cast<float>(12 * k);
            auto& color = colors[static_cast<std::size_t>(k)];
            const bool is_second = subset_of(2, partition, k) == 1;
            color[0] = is_second ? step : 50.0F;
            color[1] = is_second ? 200.0F : 0.0F;
            color[2] = is_second ? 0.0F : step;
        }
        EXPECT_EQ(best_partition<2>(colors), partition);
    }
}

// The three subsets have colors along red, green and blue. If a subset is on a line together with
// another one in a different partition, both fit, so only the distances are compared with 0.
TEST(Bc7Partition, FindsAPartitionIntoThreeSubsets) {
    ColorLanes<Simd, 3> colors;
    for (int k = 0; k < kBlockTexels; ++k) {
        const int subset = subset_of(3, 14, k);
        for (int c = 0; c < 3; ++c) {
            colors[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)] =
                static_cast<float>(c == subset ? 15 * k + 7 : 40 * subset);
        }
    }
    EXPECT_EQ(best_partition<3>(colors), 14);
}

TEST(Bc7Partition, TheBestPartitionsAreSorted) {
    BestPartitions<Simd> best(2);
    best.insert(3.0F, 30);
    best.insert(1.0F, 10);
    best.insert(2.0F, 20);
    EXPECT_EQ(best.partitions[0].lanes[0], 10);
    EXPECT_EQ(best.partitions[1].lanes[0], 20);
}

}  // namespace
}  // namespace foam::texgen::bc7
