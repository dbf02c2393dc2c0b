// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/collapse.h"

#include "core/foam/rafts.h"
#include "core/foam/record_event.h"
#include "core/foam/t1_rule.h"
#include "core/network/t1.h"
#include "core/network/t2.h"

#include <algorithm>
#include <vector>

// The T2 process (E8; paper section 3, eq. 3 and Figure 2). The paper removes three-sided bubbles
// and suggests T1s for bubbles with more sides. Here, the bubble's shortest film is flipped, or, if
// it cannot flip, the shortest of the bubble's films that can. This is repeated until the bubble
// can vanish. Unlike the T1 rule (core/foam/t1_rule.h), these flips do not depend on forces. The
// number of flips is limited to twice the number of sides of the bubble. A T2 in a raft of two
// bubbles would leave no junction. A bubble of such a raft is therefore removed by tearing the film
// between the two bubbles.

namespace foam {

namespace {

// Bubbles of more than three sides vanish at a target area of this fraction of the T2 area.
constexpr double kManySidedFraction = 0.1;
// Bubbles that cannot vanish keep at least this fraction of the T2 area as their target area.
constexpr double kMinFraction = 0.1;

// Prepares the T2 of a three-sided bubble: moves the junction that will remain to the mean of the
// bubble's three junctions (paper section 3).
void move_to_mean(Foam& foam, BubbleId bubble) {
    const HalfEdgeId first = foam.network.first(bubble);
    Vec2 corner = Vec2::Zero();  // relative to the tail of `first`
    Vec2 sum = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        sum += corner;
        corner += chord(foam, h);
    }
    const JunctionId junction = foam.network.tail(first);
    place_junction(foam, junction, foam.positions[junction] + sum / 3.0);
}

void distribute_gas(Foam& foam, double gas, const std::vector<BubbleId>& neighbors) {
    for (const BubbleId neighbor : neighbors) {
        foam.target_areas[neighbor] += gas / static_cast<double>(neighbors.size());
    }
}

// Records the T2 of a bubble at the middle of its first side. The bubble is small, so any side
// would do.
void record_t2(Foam& foam, BubbleId bubble) {
    std::vector<BubbleId> bubbles{bubble};
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        bubbles.push_back(foam.network.right(h));
    }
    const FilmId film = film_of(foam.network.first(bubble));
    record_event(foam, TopologyEventKind::T2, middle_of(foam, film), bubbles);
}

void apply_t2(Foam& foam, BubbleId bubble) {
    if (foam.network.sides(bubble) == 3) {
        move_to_mean(foam, bubble);
    }
    const double gas = foam.target_areas[bubble];
    record_t2(foam, bubble);
    const Vanished vanished = vanish(foam.network, bubble);
    distribute_gas(foam, gas, vanished.neighbors);
    if (vanished.film != kNone<FilmId>) {
        foam.t1_armed[vanished.film] = 1;
        fit_half_angle(foam, vanished.film);
    }
}

// Returns the film between the two bubbles if the bubble belongs to a raft of two; otherwise
// returns kNone.
FilmId film_of_raft_of_two(const Network& network, BubbleId bubble) {
    for (const HalfEdgeId h : network.around(bubble)) {
        if (is_inside_double_bubble(network, film_of(h))) {
            return film_of(h);
        }
    }
    return kNone<FilmId>;
}

// Removes a bubble of a raft of two by tearing `film`, the film between the two bubbles. As in
// every T2, each bubble across a side of the removed bubble gets an equal share of its gas. Here
// the other bubble and the ghost get one half each.
void vanish_from_raft_of_two(Foam& foam, BubbleId bubble, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    const bool is_left = foam.network.left(h) == bubble;
    const BubbleId other = is_left ? foam.network.right(h) : foam.network.left(h);
    const BubbleIdentity removed = foam.identities[bubble];
    record_t2(foam, bubble);
    foam.target_areas[other] += 0.5 * foam.target_areas[bubble];
    tear_film(foam, film);
    std::erase_if(foam.lone_bubbles, [&](const LoneBubble& b) { return b.identity == removed; });
}

// Flips the shortest of the bubble's films that can flip. Returns false if no film can flip.
bool flip_shortest(Foam& foam, BubbleId bubble) {
    std::vector<HalfEdgeId> loop = foam.network.around(bubble);
    std::stable_sort(loop.begin(), loop.end(), [&](HalfEdgeId a, HalfEdgeId b) {
        return chord(foam, a).squaredNorm() < chord(foam, b).squaredNorm();
    });
    for (const HalfEdgeId h : loop) {
        if (can_flip(foam.network, film_of(h))) {
            flip_film(foam, film_of(h));
            return true;
        }
    }
    return false;
}

BubbleId largest_neighbor(const Foam& foam, BubbleId bubble) {
    BubbleId largest = foam.network.right(foam.network.first(bubble));
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        const BubbleId neighbor = foam.network.right(h);
        if (foam.target_areas[neighbor] > foam.target_areas[largest]) {
            largest = neighbor;
        }
    }
    return largest;
}

// If the target area of a bubble that cannot vanish is below `min_area`, raises it to `min_area`.
// The gas comes from the bubble's largest neighbor.
void keep_alive(Foam& foam, BubbleId bubble, double min_area) {
    const double deficit = min_area - foam.target_areas[bubble];
    if (deficit > 0.0) {
        foam.target_areas[largest_neighbor(foam, bubble)] -= deficit;
        foam.target_areas[bubble] += deficit;
    }
}

void collapse_or_keep(Foam& foam, BubbleId bubble, double min_area, TopologyCounts& counts) {
    if (!collapse(foam, bubble, counts)) {
        keep_alive(foam, bubble, min_area);
    }
}

}  // namespace

bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds) {
    const double area = foam.target_areas[bubble];
    const int sides = foam.network.sides(bubble);
    if (sides <= 3) {
        return area <= thresholds.t2_area;
    }
    return area <= kManySidedFraction * thresholds.t2_area;
}

bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts) {
    const FilmId inner = film_of_raft_of_two(foam.network, bubble);
    if (inner != kNone<FilmId>) {
        vanish_from_raft_of_two(foam, bubble, inner);
        ++counts.t1;
        ++counts.t2;
        return true;
    }
    const int max_flips = 2 * foam.network.sides(bubble);
    for (int flips = 0; !can_vanish(foam.network, bubble); ++flips) {
        if (flips == max_flips || !flip_shortest(foam, bubble)) {
            return false;
        }
        ++counts.t1;
    }
    apply_t2(foam, bubble);
    ++counts.t2;
    return true;
}

TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds) {
    TopologyCounts counts;
    const double min_area = kMinFraction * thresholds.t2_area;
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (is_due_to_vanish(foam, bubble, thresholds)) {
            collapse_or_keep(foam, bubble, min_area, counts);
        }
    }
    // Bubbles that vanished with a negative target area may have left their neighbors with too
    // little gas. A bubble that vanishes from a raft of two leaves a lone bubble, which may be too
    // small as well.
    for (int t2_before = -1; counts.t2 != t2_before;) {
        counts.t2 += collapse_lone(foam, [&](const LoneBubble& bubble) {
            return bubble.target_area <= thresholds.t2_area;
        });
        t2_before = counts.t2;
        for (const BubbleId bubble : foam.network.bubbles()) {
            if (foam.target_areas[bubble] < min_area) {
                collapse_or_keep(foam, bubble, min_area, counts);
            }
        }
    }
    return counts;
}

}  // namespace foam
