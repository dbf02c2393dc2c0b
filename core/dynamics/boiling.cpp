// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/boiling.h"

#include "core/dynamics/nucleation.h"
#include "core/foam/corners.h"
#include "core/foam/locate.h"
#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

// The boil (E9) is our own design. A bubble may shrink to nothing and grow again at the same point.
// It needs no T1 if it is always surrounded by the same bubbles, because its birth is then the
// inverse of its T2. While a bubble is large, T1s give it further neighbors. When it shrinks, some
// of these T1s are not undone. Therefore boiling bubbles are chosen far from each other, by
// farthest-point sampling (T. F. Gonzalez, Clustering to minimize the maximum intercluster
// distance, Theoretical Computer Science 38, 1985). Where neighbors keep changing from cycle to
// cycle, Cycle::calm makes the boiling bubbles nearby grow to smaller areas. Stratified sampling
// spreads the births over the cycle.

namespace foam {

namespace {

constexpr double kLifeFraction = 0.9;  // part of the cycle in which a boiling bubble is present
// BoilingBubble::min_area_rise, in units of the bubble's target area before the boil.
constexpr double kMinRiseFraction = 0.12;

// Returns the age at which a boiling bubble vanishes: the number of steps of the cycle since
// BoilingBubble::birth. `steps` is the number of steps of the whole cycle.
int life(int steps) {
    return static_cast<int>(std::lround(kLifeFraction * steps));
}

// Lowers distances[k] to the distance between centers[k] and `center` if this distance is smaller.
void lower_distances(const Domain& domain,
                     const std::vector<Vec2>& centers,
                     const Vec2& center,
                     std::vector<double>& distances) {
    for (std::size_t k = 0; k < centers.size(); ++k) {
        distances[k] = std::min(distances[k], domain.nearest_copy(centers[k] - center).norm());
    }
}

// Returns the indices of `count` centers, chosen by farthest-point sampling. The first center is
// random. Each further center is as far as possible from the nearest center already chosen.
std::vector<std::size_t> farthest_points(const Domain& domain,
                                         const std::vector<Vec2>& centers,
                                         std::size_t count,
                                         Random& random) {
    std::vector<double> distances(centers.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> chosen{random.below(centers.size())};
    while (chosen.size() < count) {
        lower_distances(domain, centers, centers[chosen.back()], distances);
        const auto farthest = std::max_element(distances.begin(), distances.end());
        chosen.push_back(static_cast<std::size_t>(farthest - distances.begin()));
    }
    return chosen;
}

// Returns the numbers 0 to count - 1 in random order (Fisher and Yates).
std::vector<std::size_t> random_order(std::size_t count, Random& random) {
    std::vector<std::size_t> order(count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t other = random.below(k + 1);
        order[k] = order[other];
        order[other] = k;
    }
    return order;
}

std::set<BubbleIdentity> bubbles_at(const Foam& foam, JunctionId junction) {
    std::set<BubbleIdentity> bubbles;
    for (const HalfEdgeId h : foam.network.leaving(junction)) {
        if (foam.network.left(h) != foam.network.ghost()) {
            bubbles.insert(foam.identities[foam.network.left(h)]);
        }
    }
    return bubbles;
}

// Returns the junction at which the bubbles of BoilingBubble::neighbors meet. If there are several
// such junctions, returns the junction nearest to last_position; if there is none, returns nothing.
std::optional<JunctionId> junction_between_neighbors(const Foam& foam,
                                                     const BoilingBubble& bubble) {
    std::optional<JunctionId> nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 away = foam.positions[junction] - bubble.last_position;
        const double distance = foam.domain.nearest_copy(away).norm();
        if (distance < smallest && bubbles_at(foam, junction) == bubble.neighbors) {
            smallest = distance;
            nearest = junction;
        }
    }
    return nearest;
}

}  // namespace

std::vector<BoilingBubble> choose_boiling_bubbles(
    const Foam& foam, double fraction, double rise, int steps, Random& random) {
    std::vector<BubbleId> bubbles;
    std::vector<Vec2> centers;
    for (const BubbleId bubble : foam.network.bubbles()) {
        bubbles.push_back(bubble);
        centers.push_back(mean_corner(foam, bubble));
    }
    if (bubbles.empty()) {
        return {};
    }
    const double share = std::round(fraction * static_cast<double>(bubbles.size()));
    const std::size_t count =
        std::clamp<std::size_t>(static_cast<std::size_t>(share), 1, bubbles.size());
    const std::vector<std::size_t> order = random_order(count, random);
    std::vector<BoilingBubble> boiling;
    for (const std::size_t k : farthest_points(foam.domain, centers, count, random)) {
        const double turn = (static_cast<double>(order[boiling.size()]) + random.uniform()) /
                            static_cast<double>(count);
        const double area = foam.target_areas[bubbles[k]];
        boiling.push_back({.identity = foam.identities[bubbles[k]],
                           .birth = static_cast<int>(turn * steps),
                           .area_rise = rise * area,
                           .min_area_rise = kMinRiseFraction * area,
                           .last_position = centers[k]});
    }
    return boiling;
}

std::optional<double> area_at(const BoilingBubble& bubble,
                              int position,
                              int steps,
                              double first_area) {
    const int age = (position + steps - bubble.birth) % steps;
    if (age == 0 || age >= life(steps)) {
        return std::nullopt;
    }
    const double wave = ieee::sin(std::numbers::pi * age / life(steps));
    return first_area + bubble.area_rise * wave * wave;
}

bool give_birth(Foam& foam, const BoilingBubble& bubble, double area) {
    if (foam.network.junction_count() == 0) {
        return false;
    }
    const std::optional<JunctionId> known = junction_between_neighbors(foam, bubble);
    const JunctionId junction = known ? *known : nearest_junction(foam, bubble.last_position);
    return nucleate_at_junction(foam, junction, area, bubble.identity).has_value();
}

void record_end(BoilingBubble& bubble, const TopologyEvent& event, const Vec2& translation) {
    const std::set<BubbleIdentity> neighbors(event.bubbles.begin() + 1, event.bubbles.end());
    bubble.neighbors_changed = neighbors != bubble.neighbors;
    bubble.neighbors = neighbors;
    bubble.last_position = event.position + translation;
}

}  // namespace foam
