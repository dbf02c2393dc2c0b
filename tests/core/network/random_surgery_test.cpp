// SPDX-License-Identifier: Apache-2.0

#include "core/foam/random.h"
#include "core/network/t1.h"
#include "core/network/t2.h"
#include "core/network/validate.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace foam {
namespace {

using test::is_valid;

constexpr int kMaxOperations = 200000;  // far more than any of these foams needs

template <class Id>
Id any_of(const LiveRange<Id>& range, Random& random) {
    std::vector<Id> ids;
    for (const Id id : range) {
        ids.push_back(id);
    }
    return ids[random.below(ids.size())];
}

struct Surgeries {
    int t1 = 0;
    int rejected_t1 = 0;
    int t2_of_two = 0;
    int t2_of_three = 0;
};

void try_t1(Network& network, Random& random, Surgeries& done) {
    const FilmId film = any_of(network.films(), random);
    if (can_flip(network, film)) {
        flip(network, film);
        ++done.t1;
    } else {
        ++done.rejected_t1;
    }
}

void try_t2(Network& network, Random& random, Surgeries& done) {
    const BubbleId bubble = any_of(network.bubbles(), random);
    const int sides = network.sides(bubble);
    // On a torus, a bubble of two or three sides can always vanish.
    EXPECT_EQ(can_vanish(network, bubble), sides <= 3);
    if (can_vanish(network, bubble)) {
        vanish(network, bubble);
        ++(sides == 2 ? done.t2_of_two : done.t2_of_three);
    }
}

// Makes random T1s and, less often, T2s until one bubble is left, which is its own neighbor on all
// six sides. Validates the network after each operation. Returns the numbers of operations.
Surgeries remove_all_but_one(Network& network, std::uint64_t seed) {
    Random random(seed);
    Surgeries done;
    for (int k = 0; k < kMaxOperations && network.bubble_count() > 1; ++k) {
        if (random.below(4) == 0) {
            try_t2(network, random, done);
        } else {
            try_t1(network, random, done);
        }
        if (!is_valid(network)) {
            ADD_FAILURE() << *find_fault(network) << " after operation " << k;
            break;
        }
    }
    return done;
}

void expect_one_bubble_left(int bubbles, std::uint64_t seed) {
    SCOPED_TRACE(std::to_string(bubbles) + " bubbles, seed " + std::to_string(seed));
    Network network = test::raw_foam(bubbles, seed).network;
    const Surgeries done = remove_all_but_one(network, seed);
    EXPECT_EQ(network.bubble_count(), 1U);
    EXPECT_EQ(done.t2_of_two + done.t2_of_three, bubbles - 1);
    EXPECT_EQ(network.sides(*network.bubbles().begin()), 6);
}

TEST(RandomSurgery, KeepsSmallFoamsValidDownToTheLastBubble) {
    for (int bubbles = 2; bubbles <= 12; ++bubbles) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            expect_one_bubble_left(bubbles, seed);
        }
    }
}

TEST(RandomSurgery, KeepsLargerFoamsValidDownToTheLastBubble) {
    for (const int bubbles : {30, 80, 200}) {
        expect_one_bubble_left(bubbles, 1);
    }
}

// The tests above are useful only if T1s, rejected T1s and both kinds of T2 occur.
TEST(RandomSurgery, CoversEveryCase) {
    Network network = test::raw_foam(80, 2).network;
    const Surgeries done = remove_all_but_one(network, 2);
    EXPECT_GT(done.t1, 500);
    EXPECT_GT(done.rejected_t1, 10);
    EXPECT_GT(done.t2_of_two, 5);
    EXPECT_GT(done.t2_of_three, 5);
}

// RapidCheck shrinks a failing sequence of films to a short one.
RC_GTEST_PROP(RandomSurgery, AnySequenceOfFlipsKeepsTheNetworkValid, ()) {
    Network network = test::raw_foam(*rc::gen::inRange(2, 9), 3).network;
    const auto films = *rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(network.film_slots())));
    for (const std::uint32_t film : films) {
        if (can_flip(network, FilmId{film})) {
            flip(network, FilmId{film});
            RC_ASSERT(!find_fault(network).has_value());
        }
    }
}

}  // namespace
}  // namespace foam
