// SPDX-License-Identifier: Apache-2.0

#include "core/network/split.h"

#include "core/network/t1.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

using test::is_valid;

FilmId film_between(const Network& network, std::size_t a, std::size_t b) {
    return film_of(test::side_between(network, id_at<BubbleId>(a), id_at<BubbleId>(b)));
}

FilmId first_that_splits(const Network& network) {
    for (const FilmId film : network.films()) {
        if (can_split(network, film)) {
            return film;
        }
    }
    return kNone<FilmId>;
}

TEST(Split, IsForFilmsWithTheGhostAtBothEnds) {
    const Network network = test::flower(1.0).network;
    EXPECT_FALSE(can_split(network, film_between(network, 0, 1)));
    EXPECT_FALSE(can_split(network, film_between(network, 1, index_of(network.ghost()))));
    const Network chain = test::chain().network;
    EXPECT_TRUE(can_split(chain, film_between(chain, 1, 2)));
    EXPECT_FALSE(can_flip(chain, film_between(chain, 1, 2)));
    const Network domain = test::raw_foam(10, 1).network;
    for (const FilmId film : domain.films()) {
        EXPECT_FALSE(can_split(domain, film));
    }
}

// A chain of four bubbles becomes two rafts of two. Bubble 1 had four sides: one is removed, and
// two of the others become one.
TEST(Split, PartsAChainIntoTwoRafts) {
    Network network = test::chain().network;
    const FilmId torn = film_between(network, 1, 2);
    const Split result = split(network, torn);
    EXPECT_TRUE(is_valid(network));
    EXPECT_TRUE(result.loose.empty());
    EXPECT_EQ(result.joined.size(), 2U);
    EXPECT_FALSE(network.is_live(torn));
    EXPECT_EQ(network.film_count(), 6U);
    EXPECT_EQ(network.junction_count(), 4U);
    EXPECT_EQ(network.bubble_count(), 4U);
    for (const BubbleId bubble : network.bubbles()) {
        EXPECT_EQ(network.sides(bubble), 2);
    }
    EXPECT_EQ(network.sides(network.ghost()), 4);
    for (const FilmId film : result.joined) {
        EXPECT_TRUE(network.is_outer(film));
    }
    network.renumber(network.live_ids());
    EXPECT_TRUE(is_valid(network));
}

TEST(Split, SetsTheLastBubbleOfAChainLoose) {
    Network network = test::chain().network;
    const Split result = split(network, film_between(network, 0, 1));
    EXPECT_TRUE(is_valid(network));
    ASSERT_EQ(result.loose, std::vector<BubbleId>{BubbleId{0}});
    EXPECT_FALSE(network.is_live(BubbleId{0}));
    EXPECT_EQ(network.bubble_count(), 3U);
    EXPECT_EQ(network.film_count(), 6U);
    EXPECT_EQ(network.sides(BubbleId{1}), 2);
}

TEST(Split, OfTwoBubblesLeavesNothing) {
    Network network = test::double_bubble(1.0, 1.0).network;
    const Split result = split(network, film_between(network, 0, 1));
    EXPECT_EQ(result.loose.size(), 2U);
    EXPECT_TRUE(result.joined.empty());
    EXPECT_EQ(network.film_count(), 0U);
    EXPECT_EQ(network.junction_count(), 0U);
    EXPECT_EQ(network.bubble_count(), 0U);
    EXPECT_EQ(network.sides(network.ghost()), 0);
    EXPECT_TRUE(is_valid(network));
    network.renumber(network.live_ids());
    EXPECT_TRUE(is_valid(network));
    EXPECT_TRUE(network.is_live(network.ghost()));
}

// The ghost had two boundaries and now has one.
TEST(Split, OpensARing) {
    Network network = test::ring().network;
    const Split result = split(network, film_between(network, 2, 3));
    EXPECT_TRUE(is_valid(network));
    EXPECT_TRUE(result.loose.empty());
    EXPECT_EQ(network.sides(network.ghost()), 10);
    for (std::size_t k = 3; k < 7; ++k) {
        EXPECT_TRUE(can_split(network, film_between(network, k % 6, (k + 1) % 6)));
    }
}

// The first split opens the ring. Each further split separates one bubble, and the last split
// separates two.
TEST(Split, TakesARingApart) {
    Network network = test::ring().network;
    while (network.film_count() > 0) {
        split(network, first_that_splits(network));
        ASSERT_TRUE(is_valid(network));
    }
    EXPECT_EQ(network.bubble_count(), 0U);
}

}  // namespace
}  // namespace foam
