// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/chain.h"

#include "core/geometry/elementary.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <unordered_map>

namespace foam::texgen {

std::vector<DrawnArc> arcs_of(const Chain& chain) {
    std::vector<DrawnArc> arcs;
    arcs.reserve(chain.steps.size());
    Vec2 tail = chain.tail;
    for (const Chain::Step& step : chain.steps) {
        arcs.push_back({tail, step.head, step.half_angle});
        tail = step.head;
    }
    return arcs;
}

Chain chain_of(std::span<const DrawnArc> arcs, bool is_closed) {
    Chain chain{arcs.empty() ? Vec2(0.0, 0.0) : arcs.front().tail, {}, is_closed};
    chain.steps.reserve(arcs.size());
    for (const DrawnArc& arc : arcs) {
        chain.steps.push_back({arc.head, arc.half_angle});
    }
    return chain;
}

Chain reversed(const Chain& chain) {
    const std::vector<DrawnArc> arcs = arcs_of(chain);
    Chain back{chain.head(), {}, chain.is_closed};
    for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc) {
        back.steps.push_back({arc->tail, -arc->half_angle});
    }
    return back;
}

double signed_area(const Chain& chain) {
    double area = 0.0;
    for (const DrawnArc& arc : arcs_of(chain)) {
        area += 0.5 * cross(arc.tail - chain.tail, arc.head - chain.tail) + segment_area(arc.arc());
    }
    return area;
}

namespace {

// The segment of an arc is the region between the arc and its chord. Returns the magnitude of the
// first moment of the segment about the chord. Let c be the length of the chord. About the line
// that is parallel to the chord and goes through the center of the circle, the moment is c³ / 12.
// The distance of this line from the chord is (c / 2) cot(half angle), negative beyond 90 degrees.
double segment_moment(const FilmArc& arc) {
    const double length = arc.chord.norm();
    const auto [sine, cosine] = ieee::sincos(std::abs(arc.half_angle));
    if (sine < 1e-8) {
        return 0.0;
    }
    const double area = std::abs(segment_area(arc));
    return length * (length * length / 12.0 - 0.5 * area * cosine / sine);
}

}  // namespace

Vec2 centroid(const Chain& chain) {
    double area = 0.0;
    Vec2 moment(0.0, 0.0);  // about chain.tail
    for (const DrawnArc& drawn : arcs_of(chain)) {
        const FilmArc arc = drawn.arc();
        const Vec2 tail = drawn.tail - chain.tail;
        const Vec2 head = drawn.head - chain.tail;
        const double triangle = 0.5 * cross(tail, head);
        const double segment = segment_area(arc);
        area += triangle + segment;
        moment += triangle / 3.0 * (tail + head) + 0.5 * segment * (tail + head);
        if (arc.chord.squaredNorm() > 0.0) {
            moment -= segment_moment(arc) * turned_left(arc.chord.normalized());
        }
    }
    return chain.tail + moment / area;
}

void include(const Chain& chain, Box& box) {
    constexpr int kPoints = 16;
    for (const DrawnArc& arc : arcs_of(chain)) {
        for (int k = 0; k <= kPoints; ++k) {
            const Vec2 point = arc.tail + point_at(arc.arc(), static_cast<double>(k) / kPoints);
            box.low = box.low.cwiseMin(point);
            box.high = box.high.cwiseMax(point);
        }
    }
}

Chain circle(const Vec2& center, double radius) {
    constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
    const Vec2 right = center + Vec2(radius, 0.0);
    return {right, {{center - Vec2(radius, 0.0), kQuarterTurn}, {right, kQuarterTurn}}, true};
}

namespace {

// An end of an arc of a net: 2k is the tail of arc k, 2k + 1 is its head.
using EndIndex = std::size_t;
constexpr EndIndex kNoEnd = static_cast<EndIndex>(-1);

// Returns, for each end, the end with which it is paired at its node, or kNoEnd. At most one end of
// a node stays without a partner.
std::vector<EndIndex> paired_ends(std::span<const NetArc> arcs) {
    std::vector<EndIndex> partner(2 * arcs.size(), kNoEnd);
    std::unordered_map<std::uint64_t, EndIndex> waiting;
    for (EndIndex end = 0; end < partner.size(); ++end) {
        const NetArc& arc = arcs[end / 2];
        const auto [found, is_new] =
            waiting.try_emplace(end % 2 == 0 ? arc.tail_node : arc.head_node, end);
        if (!is_new) {
            partner[end] = found->second;
            partner[found->second] = end;
            waiting.erase(found);
        }
    }
    return partner;
}

// Returns the chain that begins at an end of an arc, and marks its arcs as used.
Chain chain_from(EndIndex start,
                 std::span<const NetArc> arcs,
                 const std::vector<EndIndex>& partner,
                 std::vector<bool>& used) {
    std::vector<DrawnArc> found;
    EndIndex end = start;
    do {
        const std::size_t k = end / 2;
        used[k] = true;
        found.push_back(end % 2 == 0 ? arcs[k].arc : reversed(arcs[k].arc));
        end = partner[end ^ 1U];
    } while (end != kNoEnd && end != start);
    return chain_of(found, end == start);
}

}  // namespace

std::vector<Chain> joined(std::span<const NetArc> arcs) {
    const std::vector<EndIndex> partner = paired_ends(arcs);
    std::vector<bool> used(arcs.size(), false);
    std::vector<Chain> chains;
    // Open chains begin at ends without a partner. All arcs that remain are in closed chains.
    for (const bool is_open : {true, false}) {
        for (EndIndex end = 0; end < partner.size(); ++end) {
            if (!used[end / 2] && (!is_open || partner[end] == kNoEnd)) {
                chains.push_back(chain_from(end, arcs, partner, used));
            }
        }
    }
    return chains;
}

}  // namespace foam::texgen
