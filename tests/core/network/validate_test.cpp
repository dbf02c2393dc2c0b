// SPDX-License-Identifier: Apache-2.0

#include "core/network/validate.h"

#include "core/foam/honeycomb.h"
#include "core/network/t1.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace foam {
namespace {

using test::is_valid;
using test::side_between;

constexpr HalfEdgeId kFirst{0};  // first half-edge of bubble 0

Network hexagons() {
    return honeycomb(4, 4).network;
}

TEST(Validate, HoneycombsAreValid) {
    for (int columns = 1; columns <= 5; ++columns) {
        for (int rows = 2; rows <= 6; rows += 2) {
            EXPECT_TRUE(is_valid(honeycomb(columns, rows).network)) << columns << " x " << rows;
        }
    }
    EXPECT_TRUE(is_valid(test::single_bubble().network));
    EXPECT_TRUE(is_valid(Network()));
}

// Each of the following tests creates one fault. They are in the order in which find_fault searches
// for faults.

TEST(Validate, FindsAMissingSuccessor) {
    Network network = hexagons();
    network.set_next(kFirst, kNone<HalfEdgeId>);
    EXPECT_EQ(find_fault(network), "half-edge 0 is followed by a film that does not exist");
}

TEST(Validate, FindsADeadSuccessor) {
    Network network = hexagons();
    network.remove(film_of(network.next(kFirst)));
    EXPECT_EQ(find_fault(network), "half-edge 0 is followed by a film that does not exist");
}

TEST(Validate, FindsADeadBubble) {
    Network network = hexagons();
    network.remove(BubbleId{0});
    EXPECT_EQ(find_fault(network), "half-edge 0 has a bubble on its left that does not exist");
}

TEST(Validate, FindsAMissingBubble) {
    Network network = hexagons();
    network.set_left(kFirst, kNone<BubbleId>);
    EXPECT_EQ(find_fault(network), "half-edge 0 has a bubble on its left that does not exist");
}

TEST(Validate, FindsADeadJunction) {
    Network network = hexagons();
    network.remove(network.tail(kFirst));
    EXPECT_EQ(find_fault(network), "half-edge 0 starts at a junction that does not exist");
}

// A new film is not yet joined to any junction. The 4 x 4 hexagons have the films 0 to 47.
TEST(Validate, FindsAMissingJunction) {
    Network network = hexagons();
    const HalfEdgeId added = forward_side(network.add_film());
    network.set_next(added, added);
    EXPECT_EQ(find_fault(network), "half-edge 96 starts at a junction that does not exist");
}

TEST(Validate, FindsASuccessorThatBeginsElsewhere) {
    Network network = hexagons();
    network.set_next(kFirst, network.next(network.next(kFirst)));
    EXPECT_EQ(find_fault(network), "half-edge 0 does not end where its successor begins");
}

TEST(Validate, FindsASuccessorOfAnotherBubble) {
    Network network = hexagons();
    network.set_left(kFirst, BubbleId{9});
    EXPECT_EQ(find_fault(network),
              "half-edge 0 and its successor have different bubbles on their left");
}

TEST(Validate, FindsARepresentativeThatDoesNotLeaveItsJunction) {
    Network network = hexagons();
    const JunctionId tail = network.tail(kFirst);
    network.set_tail(kFirst, network.head(kFirst));  // now outgoing at its head
    network.set_tail(kFirst, tail);
    EXPECT_EQ(find_fault(network),
              "junction " + std::to_string(index_of(network.head(kFirst))) +
                  " has an outgoing half-edge that does not leave it");
}

// A film is contracted to a point, so that a junction joins four films.
TEST(Validate, FindsAFourfoldJunction) {
    Network network = hexagons();
    const T1Site site = t1_site(network, FilmId{0});
    const JunctionId kept = network.tail(site.film);
    const JunctionId gone = network.head(site.film);
    network.set_tail(site.after_left, kept);
    network.set_tail(twin(site.before_right), kept);
    network.set_next(site.before_left, site.after_left);
    network.set_next(site.before_right, site.after_right);
    network.remove(FilmId{0});
    network.remove(gone);
    EXPECT_EQ(find_fault(network),
              "junction " + std::to_string(index_of(kept)) + " does not join three films");
}

TEST(Validate, FindsARepresentativeThatDoesNotBorderItsBubble) {
    Network network = hexagons();
    network.set_first(BubbleId{3}, network.first(BubbleId{4}));
    EXPECT_EQ(find_fault(network), "bubble 3 has a first half-edge that does not border it");
}

TEST(Validate, FindsABubbleOfOneSide) {
    Network network = hexagons();
    network.set_sides(BubbleId{3}, 1);
    EXPECT_EQ(find_fault(network), "bubble 3 has fewer than two sides");
}

// In a row of one bubble, bubble 0 is its own neighbor across a film: the two sides of this film
// belong to copies that are a period apart. The test changes a lattice offset between the two
// sides, so that both belong to the same copy.
TEST(Validate, FindsABubbleThatTouchesItself) {
    Network network = honeycomb(1, 2).network;
    const HalfEdgeId across = side_between(network, BubbleId{0}, BubbleId{0});
    network.set_first(BubbleId{0}, across);
    LatticeOffset between = network.offset(across);
    for (HalfEdgeId h = network.next(across); film_of(h) != film_of(across); h = network.next(h)) {
        between = between + network.offset(h);
    }
    const HalfEdgeId wrong = network.next(across);
    network.set_offset(wrong, network.offset(wrong) - between + network.offset(across));
    EXPECT_EQ(find_fault(network), "bubble 0 touches itself across a film");
}

TEST(Validate, FindsTooManySidesCounted) {
    Network network = hexagons();
    network.set_sides(BubbleId{3}, 7);
    EXPECT_EQ(find_fault(network), "bubble 3 has fewer sides than its stored count");
}

TEST(Validate, FindsTooFewSidesCounted) {
    Network network = hexagons();
    network.set_sides(BubbleId{3}, 5);
    EXPECT_EQ(find_fault(network), "bubble 3 has more sides than its stored count");
}

TEST(Validate, FindsABoundaryThatDoesNotClose) {
    Network network = hexagons();
    network.set_offset(kFirst, network.offset(kFirst) + LatticeOffset{0, 1});
    EXPECT_EQ(find_fault(network),
              "bubble 0 has a boundary that does not close: its lattice offsets do not add up to "
              "zero");
}

// Files may contain any offsets; their sums must not overflow.
TEST(Validate, FindsOffsetsThatAreTooLarge) {
    Network network = hexagons();
    const LatticeOffset offset = network.offset(kFirst);
    network.set_offset(kFirst, {std::numeric_limits<std::int32_t>::min(), 0});
    EXPECT_EQ(find_fault(network), "film 0 has a lattice offset of too many periods");
    network.set_offset(kFirst, {0, kMaxPeriods + 1});
    EXPECT_EQ(find_fault(network), "film 0 has a lattice offset of too many periods");
    network.set_offset(kFirst, offset);
    EXPECT_EQ(find_fault(network), std::nullopt);
}

TEST(Validate, FindsALoopThatLeadsTooFarAway) {
    Network network = hexagons();
    network.set_offset(kFirst, {kMaxPeriods, 0});
    network.set_offset(network.next(kFirst), {kMaxPeriods, 0});
    EXPECT_EQ(find_fault(network), "bubble 0 has a boundary that leads too many periods away");
}

// The half-edges of bubble 1 are assigned to bubble 0, which then has two loops.
TEST(Validate, FindsABubbleOfTwoLoops) {
    Network network = hexagons();
    for (const HalfEdgeId h : network.around(BubbleId{1})) {
        network.set_left(h, BubbleId{0});
    }
    network.remove(BubbleId{1});
    EXPECT_EQ(find_fault(network), "the number of sides, 90, is not twice the number of films, 48");
}

// Two junctions are merged into one, which joins twice three films.
TEST(Validate, FindsTwoJunctionsInOne) {
    Network network = hexagons();
    const JunctionId gone = network.head(kFirst);
    for (const HalfEdgeId h : network.leaving(gone)) {
        network.set_tail(h, network.tail(kFirst));
    }
    network.remove(gone);
    EXPECT_EQ(find_fault(network),
              "the number of junctions, 31, is not two thirds of the number of films, 48");
}

// Adds an edge of a tetrahedron from corner a to corner b. Returns its forward side, which has the
// face `left` on its left and the face `right` on its right.
HalfEdgeId add_edge(Network& network, JunctionId a, JunctionId b, BubbleId left, BubbleId right) {
    const HalfEdgeId h = forward_side(network.add_film());
    network.set_tail(h, a);
    network.set_tail(twin(h), b);
    network.set_left(h, left);
    network.set_left(twin(h), right);
    network.set_first(left, h);
    network.set_first(right, twin(h));
    return h;
}

void close_face(Network& network, BubbleId face, const std::array<HalfEdgeId, 3>& loop) {
    for (std::size_t k = 0; k < 3; ++k) {
        network.set_next(loop[k], loop[(k + 1) % 3]);
    }
    network.set_sides(face, 3);
}

// A tetrahedron is a foam on a sphere. Each junction joins three films and each loop closes, but
// V - E + F = 4 - 6 + 4 = 2. Face k is opposite corner k. Corner 3 is above the triangle 0, 1, 2,
// which runs counter-clockwise if seen from above.
TEST(Validate, FindsAFoamThatIsNoTorus) {
    Network network;
    std::array<JunctionId, 4> v{};
    std::array<BubbleId, 4> f{};
    for (std::size_t k = 0; k < 4; ++k) {
        v[k] = network.add_junction();
        f[k] = network.add_bubble();
    }
    const HalfEdgeId e01 = add_edge(network, v[0], v[1], f[2], f[3]);
    const HalfEdgeId e12 = add_edge(network, v[1], v[2], f[0], f[3]);
    const HalfEdgeId e20 = add_edge(network, v[2], v[0], f[1], f[3]);
    const HalfEdgeId e03 = add_edge(network, v[0], v[3], f[1], f[2]);
    const HalfEdgeId e13 = add_edge(network, v[1], v[3], f[2], f[0]);
    const HalfEdgeId e23 = add_edge(network, v[2], v[3], f[0], f[1]);
    close_face(network, f[0], {e12, e23, twin(e13)});
    close_face(network, f[1], {e20, e03, twin(e23)});
    close_face(network, f[2], {e01, e13, twin(e03)});
    close_face(network, f[3], {twin(e01), twin(e20), twin(e12)});
    EXPECT_EQ(find_fault(network),
              "Euler's relation is violated: on a torus, junctions - films + bubbles must be 0");
}

}  // namespace
}  // namespace foam
