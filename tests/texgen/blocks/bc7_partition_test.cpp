// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_partition.h"

#include "texgen/blocks/bc7_modes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace foam::texgen::bc7 {
namespace {

// For each partition, a block whose subsets have colors on two lines that do not meet. Every texel
// has a color of its own, so every other partition mixes colors that are not on a line.
TEST(Bc7Partition, FindsThePartitionOfTheColors) {
    for (std::size_t partition = 0; partition < kPartitionMasks.size(); ++partition) {
        TexelBlock block{};
        for (int k = 0; k < kBlockTexels; ++k) {
            const auto step = static_cast<std::uint8_t>(12 * k);
            block[static_cast<std::size_t>(k)] =
                has_texel(kPartitionMasks[partition], k)
                    ? std::array<std::uint8_t, 4>{step, 200, 0, 255}
                    : std::array<std::uint8_t, 4>{50, 0, step, 255};
        }
        EXPECT_EQ(best_partitions(Colors(block))[0], static_cast<int>(partition));
    }
}

}  // namespace
}  // namespace foam::texgen::bc7
