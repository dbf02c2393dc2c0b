// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/wall_outlines.h"

#include "core/geometry/elementary.h"
#include "texgen/raster/outline/inset.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// The complement of the walls is the inset (raster/outline/inset.h) of the plane without the lines.
// The border of the plane without the lines consists of loops that pass along both sides of each
// line. At a node, a loop turns into the next line, so that no line begins on its left side.

namespace foam::texgen {

namespace {

// Side 2k of a net runs along line k from tail to head, side 2k + 1 runs back.
using SideIndex = std::size_t;

DrawnArc side_of(std::span<const NetArc> lines, SideIndex side) {
    const DrawnArc& arc = lines[side / 2].arc;
    return side % 2 == 0 ? arc : reversed(arc);
}

// Returns the direction in which a side leaves its tail, as an angle.
double leaving_angle(const DrawnArc& arc) {
    const Vec2 chord = arc.head - arc.tail;
    const double angle = ieee::atan2(chord.y(), chord.x()) - arc.half_angle;
    const auto [sine, cosine] = ieee::sincos(angle);
    return ieee::atan2(sine, cosine);
}

// Returns, for each side, the side that follows it in a loop: of the sides that leave the node at
// its head, the first one clockwise from its reverse.
std::vector<SideIndex> following_sides(std::span<const NetArc> lines) {
    std::map<std::uint64_t, std::vector<std::pair<double, SideIndex>>> leaving;
    for (SideIndex side = 0; side < 2 * lines.size(); ++side) {
        const NetArc& line = lines[side / 2];
        leaving[side % 2 == 0 ? line.tail_node : line.head_node].emplace_back(
            leaving_angle(side_of(lines, side)), side);
    }
    std::vector<SideIndex> following(2 * lines.size());
    for (auto& [node, sides] : leaving) {
        std::ranges::sort(sides);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const std::size_t clockwise = (k + sides.size() - 1) % sides.size();
            following[sides[k].second ^ 1U] = sides[clockwise].second;
        }
    }
    return following;
}

// Returns true if all lines are connected by nodes.
bool is_connected(std::span<const NetArc> lines) {
    std::map<std::uint64_t, std::vector<std::size_t>> lines_at;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines_at[lines[k].tail_node].push_back(k);
        lines_at[lines[k].head_node].push_back(k);
    }
    std::vector<bool> reached(lines.size(), false);
    std::vector<std::size_t> waiting = {0};
    reached[0] = true;
    std::size_t count = 0;
    while (!waiting.empty()) {
        const NetArc& line = lines[waiting.back()];
        waiting.pop_back();
        ++count;
        for (const std::uint64_t node : {line.tail_node, line.head_node}) {
            for (const std::size_t next : lines_at[node]) {
                if (!reached[next]) {
                    reached[next] = true;
                    waiting.push_back(next);
                }
            }
        }
    }
    return count == lines.size();
}

// Returns the loops along both sides of all lines. All coordinates are multiplied by `scale`.
ArcLoops loops_along(std::span<const NetArc> lines, double scale) {
    const std::vector<SideIndex> following = following_sides(lines);
    std::vector<bool> used(following.size(), false);
    ArcLoops loops;
    for (SideIndex start = 0; start < following.size(); ++start) {
        if (used[start]) {
            continue;
        }
        for (SideIndex side = start; !used[side]; side = following[side]) {
            used[side] = true;
            const DrawnArc arc = side_of(lines, side);
            loops.sides.push_back(
                {scale * arc.tail, pixel_arc({scale * (arc.head - arc.tail), arc.half_angle})});
        }
        loops.loop_ends.push_back(loops.sides.size());
    }
    return loops;
}

// Returns a loop in the opposite direction, as a closed chain. All coordinates are divided by
// `scale`.
Chain reversed_loop(std::span<const ArcLoops::Side> loop, double scale) {
    std::vector<DrawnArc> arcs;
    for (std::size_t k = loop.size(); k > 0; --k) {
        const ArcLoops::Side& side = loop[k - 1];
        arcs.push_back({loop[k % loop.size()].tail / scale,
                        side.tail / scale,
                        -film_arc(side.arc).half_angle});
    }
    return chain_of(arcs, true);
}

// The insets of loops, as closed chains in the opposite direction.
struct Insets {
    std::vector<Chain> chains;
    int unclosed = 0;  // number of loops that are missing
};

Insets insets_of(const ArcLoops& loops, bool is_connected, double distance, double scale) {
    Insets insets;
    const auto add = [&](const ArcLoops& found) {
        insets.unclosed += found.unclosed_loops;
        for (std::size_t k = 0; k < found.loop_ends.size(); ++k) {
            insets.chains.push_back(reversed_loop(found.loop(k), scale));
        }
    };
    InsetTracer tracer;
    if (!is_connected) {
        add(tracer.trace(loops, distance));
        return insets;
    }
    for (std::size_t k = 0; k < loops.loop_ends.size(); ++k) {
        add(tracer.trace_loop(loops, k, distance));
    }
    return insets;
}

double mean_chord(std::span<const NetArc> lines) {
    double sum = 0.0;
    for (const NetArc& line : lines) {
        sum += (line.arc.head - line.arc.tail).norm();
    }
    return sum / static_cast<double>(lines.size());
}

}  // namespace

std::vector<Chain> wall_outlines(std::span<const NetArc> lines, double width) {
    // The tolerances of insets are in pixels. They suit lines that are about this long.
    constexpr double kMeanChord = 30.0;
    // If walls touch each other in a point, rounding errors may hide how outlines continue there. A
    // slightly larger width then gives an unambiguous result.
    constexpr int kMaxAttempts = 4;
    constexpr double kLargerWidth = 1e-6;
    if (lines.empty()) {
        return {};
    }
    const double scale = kMeanChord / mean_chord(lines);
    const ArcLoops loops = loops_along(lines, scale);
    const bool connected = is_connected(lines);  // then each loop bounds a part of the plane alone
    Insets insets;
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        const double distance = 0.5 * scale * width * (1.0 + attempt * kLargerWidth);
        insets = insets_of(loops, connected, distance, scale);
        if (insets.unclosed == 0) {
            break;
        }
    }
    return insets.chains;
}

}  // namespace foam::texgen
