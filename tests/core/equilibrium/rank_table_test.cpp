// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/rank_table.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace foam {
namespace {

// Checks the table of a list that contains every `spacing`-th of `slots` ids, from 3 on.
void expect_ranks(std::size_t slots, std::size_t spacing) {
    std::vector<BubbleId> list;
    for (std::size_t k = 3; k < slots; k += spacing) {
        list.push_back(id_at<BubbleId>(k));
    }
    const RankTable<BubbleId> ranks(list, slots);
    int next = 0;
    for (std::size_t k = 0; k < slots; ++k) {
        const bool is_in_list = k >= 3 && (k - 3) % spacing == 0;
        EXPECT_EQ(ranks[id_at<BubbleId>(k)], is_in_list ? next++ : -1) << k << " of " << slots;
    }
    EXPECT_EQ(static_cast<std::size_t>(next), list.size());
}

TEST(RankTable, ReturnsIndicesInListsOfManyIds) {
    expect_ranks(1000, 1);
    expect_ranks(1000, 7);
}

TEST(RankTable, ReturnsIndicesInListsOfFewIds) {
    expect_ranks(1000, 17);
    expect_ranks(1000, 64);  // a hash by remainder would map them to one slot
    expect_ranks(1000, 999);
    expect_ranks(100000, 4096);
}

TEST(RankTable, ReturnsNegativeIndicesWithoutAList) {
    const RankTable<FilmId> ranks({}, 50);
    EXPECT_EQ(ranks[FilmId{0}], -1);
    EXPECT_EQ(ranks[FilmId{49}], -1);
}

}  // namespace
}  // namespace foam
