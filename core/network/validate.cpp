// SPDX-License-Identifier: Apache-2.0

#include "core/network/validate.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <vector>

// The lattice offsets and half-edges of each film are checked first, then junctions, bubbles and
// counts. In the plane, the boundaries of the ghost are checked next; then each lattice offset must
// be zero. Euler's relation is checked last. Later checks rely on earlier checks, for example when
// they follow successors.

namespace foam {

namespace {

using Fault = std::optional<std::string>;

template <class Id>
Fault fault(const char* kind, Id id, const char* what) {
    std::ostringstream text;
    text << kind << ' ' << index_of(id) << ' ' << what;
    return text.str();
}

Fault half_edge_fault(const Network& network, HalfEdgeId h) {
    const HalfEdgeId next = network.next(h);
    if (index_of(next) >= 2 * network.film_slots() || !network.is_live(film_of(next))) {
        return fault("half-edge", h, "is followed by a film that does not exist");
    }
    const JunctionId tail = network.tail(h);
    if (index_of(tail) >= network.junction_slots() || !network.is_live(tail)) {
        return fault("half-edge", h, "starts at a junction that does not exist");
    }
    const BubbleId left = network.left(h);
    if (index_of(left) >= network.bubble_slots() || !network.is_live(left)) {
        return fault("half-edge", h, "has a bubble on its left that does not exist");
    }
    if (network.tail(next) != network.head(h)) {
        return fault("half-edge", h, "does not end where its successor begins");
    }
    if (network.left(next) != network.left(h)) {
        return fault("half-edge", h, "and its successor have different bubbles on their left");
    }
    return std::nullopt;
}

Fault junction_fault(const Network& network, JunctionId junction) {
    const HalfEdgeId out = network.outgoing(junction);
    if (index_of(out) >= 2 * network.film_slots() || !network.is_live(film_of(out)) ||
        network.tail(out) != junction) {
        return fault("junction", junction, "has an outgoing half-edge that does not leave it");
    }
    const std::array<HalfEdgeId, 3> leaving = network.leaving(junction);
    if (network.next(twin(leaving[2])) != leaving[0] || leaving[0] == leaving[1]) {
        return fault("junction", junction, "does not join three films");
    }
    return std::nullopt;
}

// Checks the loop around a bubble. On a torus, a bubble may touch a periodic copy of itself. The
// film between the two copies then occurs twice in the loop, at different lattice offsets. If a
// film occurs twice at the same offset, the bubble touches itself, which is a fault.
Fault loop_fault(const Network& network, BubbleId bubble) {
    std::set<std::array<std::size_t, 3>> seen;
    LatticeOffset h_tail;  // sum of the offsets along the loop up to the tail of h
    HalfEdgeId h = network.first(bubble);
    for (int side = 0; side < network.sides(bubble); ++side) {
        const LatticeOffset h_head = h_tail + network.offset(h);
        if (exceeds_max_periods(h_head)) {
            return fault("bubble", bubble, "has a boundary that leads too many periods away");
        }
        const LatticeOffset film_tail = is_forward(h) ? h_tail : h_head;
        if (!seen.insert({index_of(film_of(h)),
                          static_cast<std::size_t>(film_tail.i),
                          static_cast<std::size_t>(film_tail.j)})
                 .second) {
            return fault("bubble", bubble, "touches itself across a film");
        }
        h_tail = h_head;
        h = network.next(h);
        if (h == network.first(bubble) && side + 1 < network.sides(bubble)) {
            return fault("bubble", bubble, "has fewer sides than its stored count");
        }
    }
    if (h != network.first(bubble)) {
        return fault("bubble", bubble, "has more sides than its stored count");
    }
    return h_tail == LatticeOffset{}
               ? std::nullopt
               : fault("bubble",
                       bubble,
                       "has a boundary that does not close: its lattice offsets do not add up to "
                       "zero");
}

Fault bubble_fault(const Network& network, BubbleId bubble) {
    const HalfEdgeId first = network.first(bubble);
    if (index_of(first) >= 2 * network.film_slots() || !network.is_live(film_of(first)) ||
        network.left(first) != bubble) {
        return fault("bubble", bubble, "has a first half-edge that does not border it");
    }
    if (network.sides(bubble) < 2) {
        return fault("bubble", bubble, "has fewer than two sides");
    }
    return loop_fault(network, bubble);
}

Fault wrong_count(const char* elements, std::size_t count, const char* factor, std::size_t films) {
    std::ostringstream text;
    text << "the number of " << elements << ", " << count << ", is not " << factor
         << " the number of films, " << films;
    return text.str();
}

Fault count_fault(const Network& network) {
    std::size_t sides = 0;
    for (const BubbleId bubble : network.bubbles()) {
        sides += static_cast<std::size_t>(network.sides(bubble));
    }
    if (network.ghost() != kNone<BubbleId>) {
        sides += static_cast<std::size_t>(network.sides(network.ghost()));
    }
    const std::size_t films = network.film_count();
    if (sides != 2 * films) {
        return wrong_count("sides", sides, "twice", films);
    }
    if (3 * network.junction_count() != 2 * films) {
        return wrong_count("junctions", network.junction_count(), "two thirds of", films);
    }
    return std::nullopt;
}

// Checks the half-edges of the ghost, one boundary after the other, and counts the boundaries.
class GhostBoundaries {
  public:
    explicit GhostBoundaries(const Network& network)
        : network_(network), seen_(2 * network.film_slots(), false) {}

    Fault find_fault() {
        for (const FilmId film : network_.films()) {
            for (const HalfEdgeId h : {forward_side(film), twin(forward_side(film))}) {
                if (network_.left(h) != network_.ghost() || seen_[index_of(h)]) {
                    continue;
                }
                if (Fault found = check_boundary(h)) {
                    return found;
                }
            }
        }
        return half_edges_ == network_.sides(network_.ghost())
                   ? std::nullopt
                   : fault("bubble", network_.ghost(), "has a wrong stored count of sides");
    }

    std::size_t count() const { return count_; }

  private:
    // Checks the boundary that contains the half-edge `start`.
    Fault check_boundary(HalfEdgeId start) {
        ++count_;
        HalfEdgeId h = start;
        do {
            if (seen_[index_of(h)]) {
                return fault("half-edge", h, "is in two boundaries of the ghost bubble");
            }
            if (network_.right(h) == network_.ghost()) {
                return fault("half-edge", h, "has the ghost bubble on both sides");
            }
            seen_[index_of(h)] = true;
            ++half_edges_;
            h = network_.next(h);
        } while (h != start);
        return network_.next(start) == start
                   ? fault("film",
                           film_of(start),
                           "is the only film of a boundary of the ghost bubble; at least two are "
                           "needed")
                   : std::nullopt;
    }

    const Network& network_;
    std::vector<bool> seen_;
    std::size_t count_ = 0;
    int half_edges_ = 0;  // number of half-edges in all boundaries
};

// Marks all junctions that are connected to `start` by films.
void mark_raft(const Network& network, JunctionId start, std::vector<bool>& seen) {
    std::vector<JunctionId> open{start};
    seen[index_of(start)] = true;
    while (!open.empty()) {
        const JunctionId junction = open.back();
        open.pop_back();
        for (const HalfEdgeId h : network.leaving(junction)) {
            const JunctionId head = network.head(h);
            if (!seen[index_of(head)]) {
                seen[index_of(head)] = true;
                open.push_back(head);
            }
        }
    }
}

// Returns the number of connected components of the network.
std::size_t raft_count(const Network& network) {
    std::vector<bool> seen(network.junction_slots(), false);
    std::size_t rafts = 0;
    for (const JunctionId start : network.junctions()) {
        if (!seen[index_of(start)]) {
            ++rafts;
            mark_raft(network, start, seen);
        }
    }
    return rafts;
}

Fault torus_fault(const Network& network) {
    return network.junction_count() + network.bubble_count() == network.film_count()
               ? std::nullopt
               : Fault(
                     "Euler's relation is violated: on a torus, junctions - films + bubbles must "
                     "be 0");
}

Fault plane_fault(const Network& network) {
    GhostBoundaries boundaries(network);
    if (Fault found = boundaries.find_fault()) {
        return found;
    }
    for (const FilmId film : network.films()) {
        if (network.offset(forward_side(film)) != LatticeOffset{}) {
            return fault("film", film, "has a lattice offset, which only a torus allows");
        }
    }
    return network.junction_count() + network.bubble_count() + boundaries.count() ==
                   network.film_count() + 2 * raft_count(network)
               ? std::nullopt
               : Fault(
                     "Euler's relation is violated: in the plane, junctions - films + bubbles + "
                     "boundaries must be twice the number of rafts");
}

}  // namespace

std::optional<std::string> find_fault(const Network& network) {
    for (const FilmId film : network.films()) {
        if (exceeds_max_periods(network.offset(forward_side(film)))) {
            return fault("film", film, "has a lattice offset of too many periods");
        }
        for (const HalfEdgeId h : {forward_side(film), twin(forward_side(film))}) {
            if (Fault found = half_edge_fault(network, h)) {
                return found;
            }
        }
    }
    for (const JunctionId junction : network.junctions()) {
        if (Fault found = junction_fault(network, junction)) {
            return found;
        }
    }
    for (const BubbleId bubble : network.bubbles()) {
        if (Fault found = bubble_fault(network, bubble)) {
            return found;
        }
    }
    if (Fault found = count_fault(network)) {
        return found;
    }
    return network.ghost() == kNone<BubbleId> ? torus_fault(network) : plane_fault(network);
}

}  // namespace foam
