// SPDX-License-Identifier: Apache-2.0

#include "core/network/insertion.h"

#include <array>

// Each of the two insertions is the inverse of a T2 (t2.cpp). New films have a lattice offset of
// zero: they lead to the stored positions of the new junctions without a translation. The caller
// sets these positions accordingly.

namespace foam {

namespace {

void gain_sides(Network& network, BubbleId bubble, int count) {
    network.set_sides(bubble, network.sides(bubble) + count);
}

// Makes `next` the successor of h along the same bubble.
void join(Network& network, HalfEdgeId h, HalfEdgeId next) {
    network.set_next(h, next);
    network.set_left(next, network.left(h));
}

BubbleId add_bubble_along(Network& network, HalfEdgeId first, int sides) {
    const BubbleId bubble = network.add_bubble();
    network.set_first(bubble, first);
    network.set_sides(bubble, sides);
    return bubble;
}

}  // namespace

BubbleId insert_triangle(Network& network, JunctionId junction) {
    const auto [a, b, c] = network.leaving(junction);  // clockwise
    const std::array<HalfEdgeId, 3> outward{a, c, b};  // counter-clockwise
    std::array<JunctionId, 3> corners{junction, network.add_junction(), network.add_junction()};
    std::array<HalfEdgeId, 3> loop{};
    for (HalfEdgeId& side : loop) {
        side = forward_side(network.add_film());
    }
    const BubbleId triangle = add_bubble_along(network, loop[0], 3);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t following = (k + 1) % 3;
        network.set_tail(outward[k], corners[k]);
        network.set_tail(loop[k], corners[k]);
        network.set_tail(twin(loop[k]), corners[following]);
        network.set_left(loop[k], triangle);
        network.set_next(loop[k], loop[following]);
        join(network, twin(outward[following]), twin(loop[k]));
        join(network, twin(loop[k]), outward[k]);
        gain_sides(network, network.left(outward[k]), 1);
    }
    return triangle;
}

BubbleId insert_lens(Network& network, HalfEdgeId h) {
    const HalfEdgeId previous = network.previous(h);
    const HalfEdgeId next_of_twin = network.next(twin(h));
    const JunctionId old_tail = network.tail(h);
    const JunctionId near_corner = network.add_junction();
    const JunctionId far_corner = network.add_junction();
    // `lead` runs from the old tail to the near corner. `left` runs from the near to the far
    // corner, along the left side of the lens. `right` runs back along its right side.
    const HalfEdgeId lead = forward_side(network.add_film());
    const HalfEdgeId left = forward_side(network.add_film());
    const HalfEdgeId right = forward_side(network.add_film());
    const BubbleId lens = add_bubble_along(network, twin(left), 2);
    network.set_tail(lead, old_tail);
    network.set_tail(twin(lead), near_corner);
    network.set_tail(left, near_corner);
    network.set_tail(twin(right), near_corner);
    network.set_tail(twin(left), far_corner);
    network.set_tail(right, far_corner);
    network.set_tail(h, far_corner);
    join(network, previous, lead);
    join(network, lead, left);
    network.set_next(left, h);
    join(network, twin(h), right);
    join(network, right, twin(lead));
    network.set_next(twin(lead), next_of_twin);
    network.set_left(twin(left), lens);
    join(network, twin(left), twin(right));
    network.set_next(twin(right), twin(left));
    gain_sides(network, network.left(h), 2);
    gain_sides(network, network.right(h), 2);
    return lens;
}

}  // namespace foam
