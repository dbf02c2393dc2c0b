// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/disc_index.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

// Discs of the radius 0.3 at the integers 0, 1, 2, ...
Disc disc_at(std::size_t k) {
    return {{static_cast<double>(k), 0.0}, 0.3};
}

std::vector<std::size_t> near(DiscIndex& index, const Disc& disc) {
    const auto found = index.near(disc);
    return {found.begin(), found.end()};
}

TEST(DiscIndex, AllOfFewDiscsAreFound) {
    DiscIndex index;
    EXPECT_TRUE(near(index, {}).empty());
    index.build(3, disc_at);
    EXPECT_EQ(near(index, {{100.0, 0.0}, 1.0}), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(DiscIndex, FindsTheNearOnesOfManyDiscsInOrder) {
    DiscIndex index;
    index.build(1000, disc_at);
    EXPECT_EQ(near(index, {{500.0, 0.0}, 1.0}), (std::vector<std::size_t>{499, 500, 501}));
    EXPECT_EQ(near(index, {{500.5, 0.0}, 0.2}), (std::vector<std::size_t>{500, 501}));
    EXPECT_TRUE(near(index, {{500.5, 0.0}, 0.19}).empty());
    EXPECT_TRUE(near(index, {{500.0, 1.0}, 0.6}).empty());
}

TEST(DiscIndex, ASetCanBeReplaced) {
    DiscIndex index;
    index.build(1000, disc_at);
    index.build(DiscIndex::kFewDiscs + 1, disc_at);
    EXPECT_TRUE(near(index, {{500.0, 0.0}, 1.0}).empty());
    index.build(1, disc_at);
    EXPECT_EQ(near(index, {{500.0, 0.0}, 1.0}), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace foam::texgen
