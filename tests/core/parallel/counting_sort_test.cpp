// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/counting_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam {
namespace {

TEST(CountingSort, KeepsTheOrderWithinABucket) {
    constexpr std::size_t kBuckets = 7;
    constexpr std::size_t kParts = 5;
    constexpr std::size_t kPerPart = 40;
    const auto bucket_of = [](std::size_t item) { return item * item % kBuckets; };
    const auto visit = [&](std::size_t part, const auto& put) {
        for (std::size_t k = part * kPerPart; k < (part + 1) * kPerPart; ++k) {
            put(bucket_of(k), k);
        }
    };
    for (const int threads : {1, 2, 9}) {
        const auto all = counting_sort<std::size_t>(kBuckets, kParts, threads, visit);
        ASSERT_EQ(all.begins.size(), kBuckets + 1);
        EXPECT_EQ(all.items_of(0, kBuckets).size(), kParts * kPerPart);
        for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
            EXPECT_TRUE(std::ranges::is_sorted(all.items_of(bucket, bucket + 1)));
            for (const std::size_t item : all.items_of(bucket, bucket + 1)) {
                EXPECT_EQ(bucket_of(item), bucket);
            }
        }
    }
}

TEST(CountingSort, LeavesBucketsEmptyWithoutItems) {
    const auto all = counting_sort<int>(3, 0, 2, [](std::size_t, const auto&) {});
    EXPECT_TRUE(all.items_of(0, 3).empty());
}

}  // namespace
}  // namespace foam
