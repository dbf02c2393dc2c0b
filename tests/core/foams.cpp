// SPDX-License-Identifier: Apache-2.0

#include "tests/core/foams.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/seeding.h"
#include "core/foam/t1_rule.h"
#include "core/network/validate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace foam::test {

namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

AssertionResult same_half_edges(const Network& a, const Network& b) {
    for (std::size_t k = 0; k < 2 * a.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        if (a.tail(h) != b.tail(h) || a.left(h) != b.left(h) || a.next(h) != b.next(h) ||
            a.offset(h) != b.offset(h) || a.is_live(film_of(h)) != b.is_live(film_of(h))) {
            return AssertionFailure() << "half-edge " << k << " differs";
        }
    }
    return AssertionSuccess();
}

AssertionResult same_junctions(const Network& a, const Network& b) {
    for (std::size_t k = 0; k < a.junction_slots(); ++k) {
        const auto junction = id_at<JunctionId>(k);
        if (a.is_live(junction) != b.is_live(junction) ||
            a.outgoing(junction) != b.outgoing(junction)) {
            return AssertionFailure() << "junction " << k << " differs";
        }
    }
    return AssertionSuccess();
}

AssertionResult same_bubbles(const Network& a, const Network& b) {
    for (std::size_t k = 0; k < a.bubble_slots(); ++k) {
        const auto bubble = id_at<BubbleId>(k);
        if (a.is_live(bubble) != b.is_live(bubble) || a.first(bubble) != b.first(bubble) ||
            a.sides(bubble) != b.sides(bubble)) {
            return AssertionFailure() << "bubble " << k << " differs";
        }
    }
    return AssertionSuccess();
}

}  // namespace

AssertionResult is_valid(const Network& network) {
    if (const auto fault = find_fault(network)) {
        return AssertionFailure() << *fault;
    }
    return AssertionSuccess();
}

AssertionResult are_same(const Network& a, const Network& b) {
    if (a.film_slots() != b.film_slots() || a.junction_slots() != b.junction_slots() ||
        a.bubble_slots() != b.bubble_slots()) {
        return AssertionFailure() << "the numbers of slots differ";
    }
    for (const AssertionResult& part :
         {same_half_edges(a, b), same_junctions(a, b), same_bubbles(a, b)}) {
        if (!part) {
            return part;
        }
    }
    return AssertionSuccess();
}

AssertionResult are_same(const Foam& a, const Foam& b) {
    if (a.domain.width != b.domain.width || a.domain.height != b.domain.height ||
        a.domain.shear != b.domain.shear) {
        return AssertionFailure() << "the tori differ";
    }
    if (a.film_tension != b.film_tension || a.time != b.time) {
        return AssertionFailure() << "film tension or time differ";
    }
    if (a.positions != b.positions || a.pressures != b.pressures) {
        return AssertionFailure() << "positions or pressures differ";
    }
    if (a.target_areas != b.target_areas || a.t1_armed != b.t1_armed) {
        return AssertionFailure() << "target areas or armed films differ";
    }
    if (a.identities != b.identities || a.next_identity != b.next_identity) {
        return AssertionFailure() << "identities differ";
    }
    if (a.half_angles != b.half_angles || a.lone_bubbles != b.lone_bubbles) {
        return AssertionFailure() << "half angles or lone bubbles differ";
    }
    return are_same(a.network, b.network);
}

Foam raw_foam(int bubbles, std::uint64_t seed) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.seed = seed;
    return seed_foam(options);
}

Foam equilibrated_foam(int bubbles, std::uint64_t seed) {
    Foam foam = raw_foam(bubbles, seed);
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    return foam;
}

HalfEdgeId side_between(const Network& network, BubbleId bubble, BubbleId neighbor) {
    const std::vector<HalfEdgeId> loop = network.around(bubble);
    return *std::find_if(
        loop.begin(), loop.end(), [&](HalfEdgeId h) { return network.right(h) == neighbor; });
}

double total_target(const Foam& foam) {
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    return total;
}

Foam honeycomb_around(int sides) {
    constexpr BubbleId kBubble{5};
    constexpr std::array<BubbleId, 4> kLost{BubbleId{10}, BubbleId{4}, BubbleId{2}, BubbleId{6}};
    Foam foam = honeycomb(4, 4);
    for (std::size_t k = 0; foam.network.sides(kBubble) > sides; ++k) {
        flip_film(foam, film_of(side_between(foam.network, kBubble, kLost.at(k))));
    }
    return foam;
}

}  // namespace foam::test
