// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/shared_bubbles.h"

#include "texgen/animation/displaced_frame.h"

#include <cmath>
#include <map>
#include <numbers>

namespace foam::texgen {

namespace {

using Displacements = std::vector<std::optional<Vec2>>;

// Gives each bubble without a displacement the mean displacement of its neighbors that have one.
Displacements spread_to_neighbors(const Frame& frame, const Displacements& known) {
    Displacements all = known;
    for (const BubbleId bubble : frame.network.bubbles()) {
        Vec2 sum = Vec2::Zero();
        int count = 0;
        for (const HalfEdgeId h : frame.network.around(bubble)) {
            if (const auto& neighbor = known[index_of(frame.network.right(h))]) {
                sum += *neighbor;
                ++count;
            }
        }
        std::optional<Vec2>& own = all[index_of(bubble)];
        if (!own && count > 0) {
            own = sum / count;
        }
    }
    return all;
}

}  // namespace

Displacements displacements_of_shared(const Frame& from, const Frame& to) {
    std::map<BubbleIdentity, BubbleId> bubbles_in_to;
    for (const BubbleId bubble : to.network.bubbles()) {
        bubbles_in_to.emplace(to.bubbles[bubble].identity, bubble);
    }
    const double mean_area = from.domain.area() / static_cast<double>(from.bubbles.size());
    const double mean_diameter = 2.0 * std::sqrt(mean_area / std::numbers::pi);
    Displacements displacements(from.bubbles.size());
    for (const BubbleId bubble : from.network.bubbles()) {
        const auto found = bubbles_in_to.find(from.bubbles[bubble].identity);
        if (found == bubbles_in_to.end()) {
            continue;
        }
        const Vec2 displacement =
            from.domain.nearest_copy(mean_corner(to, found->second) - mean_corner(from, bubble));
        if (displacement.squaredNorm() <= mean_diameter * mean_diameter) {
            displacements[index_of(bubble)] = displacement;
        }
    }
    return displacements;
}

Frame moved_toward(const Frame& from, const Frame& to, double fraction) {
    if (fraction == 0.0) {
        return from;
    }
    // A bubble gets no displacement if it is more than kRounds bubbles away from every bubble that
    // has one in displacements_of_shared. Of the junctions of such a bubble, only those move that
    // belong to a nearer bubble, too.
    constexpr int kRounds = 2;
    Displacements bubble_displacements = displacements_of_shared(from, to);
    for (int round = 0; round < kRounds; ++round) {
        bubble_displacements = spread_to_neighbors(from, bubble_displacements);
    }
    const Network& network = from.network;
    Indexed<JunctionId, Vec2> junction_displacements;
    for (const JunctionId junction : network.junctions()) {
        Vec2 sum = Vec2::Zero();
        for (const HalfEdgeId h : network.leaving(junction)) {
            sum += bubble_displacements[index_of(network.left(h))].value_or(Vec2::Zero());
        }
        junction_displacements.push_back(fraction / 3.0 * sum);
    }
    Indexed<FilmId, Vec2> middle_displacements;
    for (const FilmId film : network.films()) {
        const HalfEdgeId side = forward_side(film);
        middle_displacements.push_back(0.5 * (junction_displacements[network.tail(side)] +
                                              junction_displacements[network.head(side)]));
    }
    return displaced(from, junction_displacements, middle_displacements);
}

}  // namespace foam::texgen
