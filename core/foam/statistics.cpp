// SPDX-License-Identifier: Apache-2.0

#include "core/foam/statistics.h"

#include "core/foam/measure.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace foam {

namespace {

std::size_t bubble_count(const Frame& frame) {
    return frame.bubbles.size() + frame.lone_bubbles.size();
}

double pressure(const Frame& frame, BubbleId bubble) {
    return bubble == frame.network.ghost() ? 0.0 : frame.bubbles[bubble].pressure;
}

BubbleIdentity identity(const Frame& frame, BubbleId bubble) {
    return bubble == frame.network.ghost() ? kNoIndex : frame.bubbles[bubble].identity;
}

double inflow(const Frame& frame, BubbleId bubble) {
    double sum = 0.0;
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        const double outside = pressure(frame, frame.network.right(h));
        sum += (outside - frame.bubbles[bubble].pressure) * arc_length(frame.arc(h));
    }
    return sum;
}

double energy(const Frame& frame) {
    double length = 0.0;
    for (const FilmArc& arc : frame.arcs) {
        length += arc_length(arc);
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        length += 2.0 * std::numbers::pi * lone_radius(bubble);
    }
    return frame.film_tension * length;
}

std::vector<SidesStatistics> statistics_by_sides(const Frame& frame) {
    std::map<int, SidesStatistics> sums;
    for (const BubbleId bubble : frame.network.bubbles()) {
        SidesStatistics& sum = sums[frame.network.sides(bubble)];
        ++sum.bubbles;
        sum.mean_area += frame.bubbles[bubble].area;
        sum.mean_pressure += frame.bubbles[bubble].pressure;
        sum.mean_inflow += inflow(frame, bubble);
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        SidesStatistics& sum = sums[0];
        ++sum.bubbles;
        sum.mean_area += bubble.target_area;
        sum.mean_pressure += lone_pressure(bubble, frame.film_tension);
        sum.mean_inflow -= 2.0 * std::numbers::pi * frame.film_tension;
    }
    std::vector<SidesStatistics> means;
    means.reserve(sums.size());
    for (const auto& [sides, sum] : sums) {
        const double count = sum.bubbles;
        means.push_back({sides,
                         sum.bubbles,
                         sum.mean_area / count,
                         sum.mean_pressure / count,
                         sum.mean_inflow / count});
    }
    return means;
}

// Returns the mean of `value`, a function of the number of sides of a bubble, over all bubbles.
template <class OfSides>
double mean_of(const FoamStatistics& all, OfSides value) {
    double sum = 0.0;
    for (const SidesStatistics& part : all.by_sides) {
        sum += part.bubbles * value(part.sides);
    }
    return sum / std::max(1, all.bubbles);
}

struct Neighborhood {
    double area = 0.0;
    std::vector<BubbleIdentity> neighbors;  // in increasing order
};

Neighborhood neighborhood(const Frame& frame, BubbleId bubble) {
    Neighborhood found{frame.bubbles[bubble].area, {}};
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        found.neighbors.push_back(identity(frame, frame.network.right(h)));
    }
    std::sort(found.neighbors.begin(), found.neighbors.end());
    return found;
}

std::map<BubbleIdentity, Neighborhood> neighborhoods(const Frame& frame) {
    std::map<BubbleIdentity, Neighborhood> all;
    for (const BubbleId bubble : frame.network.bubbles()) {
        all.emplace(frame.bubbles[bubble].identity, neighborhood(frame, bubble));
    }
    return all;
}

}  // namespace

double mean_area(const Frame& frame) {
    const auto bubbles = static_cast<double>(bubble_count(frame));
    if (!frame.domain.is_plane()) {
        return frame.domain.area() / bubbles;
    }
    double total = 0.0;
    for (const FrameBubble& bubble : frame.bubbles) {
        total += bubble.area;
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        total += bubble.target_area;
    }
    return total / std::max(1.0, bubbles);
}

FoamStatistics statistics(const Frame& frame) {
    FoamStatistics all;
    all.bubbles = static_cast<int>(bubble_count(frame));
    if (all.bubbles == 0) {
        return all;
    }
    all.mean_area = mean_area(frame);
    all.energy = energy(frame);
    all.by_sides = statistics_by_sides(frame);
    all.mean_sides = mean_of(all, [](int sides) { return sides; });
    all.second_moment = mean_of(
        all, [mean = all.mean_sides](int sides) { return (sides - mean) * (sides - mean); });
    return all;
}

std::vector<SidesGrowth> growth_by_sides(const Frame& before, const Frame& after) {
    const double time = after.time - before.time;
    if (time == 0.0) {
        return {};
    }
    const std::map<BubbleIdentity, Neighborhood> earlier = neighborhoods(before);
    std::map<int, SidesGrowth> sums;
    for (const auto& [identity, current] : neighborhoods(after)) {
        const auto previous = earlier.find(identity);
        if (previous != earlier.end() && previous->second.neighbors == current.neighbors) {
            SidesGrowth& sum = sums[static_cast<int>(current.neighbors.size())];
            ++sum.bubbles;
            sum.mean_rate += (current.area - previous->second.area) / time;
        }
    }
    std::vector<SidesGrowth> means;
    means.reserve(sums.size());
    for (const auto& [sides, sum] : sums) {
        means.push_back({sides, sum.bubbles, sum.mean_rate / sum.bubbles});
    }
    return means;
}

}  // namespace foam
