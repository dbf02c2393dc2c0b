// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/wall_outlines.h"

#include "core/geometry/elementary.h"
#include "texgen/raster/outline/disc_index.h"
#include "texgen/raster/outline/inset.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

// The complement of the walls consists of the points that are at least half the width of a wall
// away from every line. It is the inset (raster/outline/inset.h), at this distance, of the region
// that is the plane minus the lines. The border of this region consists of loops that pass along
// both sides of each line. At a node, a loop continues along the leftmost line, so that no other
// line begins on the left of the loop.

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

// Returns, for each side, the side that follows it in a loop. The following side leaves the node
// where the side ends. It is the first such side clockwise from the opposite side of the same line.
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

// Returns, for each line, the number of its connected component. Lines are connected by nodes.
std::vector<std::size_t> components_of(std::span<const NetArc> lines) {
    constexpr auto kNone = static_cast<std::size_t>(-1);
    std::map<std::uint64_t, std::vector<std::size_t>> lines_at;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines_at[lines[k].tail_node].push_back(k);
        lines_at[lines[k].head_node].push_back(k);
    }
    std::vector<std::size_t> components(lines.size(), kNone);
    for (std::size_t start = 0; start < lines.size(); ++start) {
        std::vector<std::size_t> waiting;
        const auto reach = [&](std::size_t line) {
            if (components[line] == kNone) {
                components[line] = start;
                waiting.push_back(line);
            }
        };
        reach(start);
        while (!waiting.empty()) {
            const NetArc& line = lines[waiting.back()];
            waiting.pop_back();
            for (const std::uint64_t node : {line.tail_node, line.head_node}) {
                std::ranges::for_each(lines_at[node], reach);
            }
        }
    }
    return components;
}

// A loop along sides of lines, and the component of these lines.
struct LineLoop {
    std::vector<ArcLoops::Side> sides;
    std::size_t component = 0;
};

// Returns the loops along both sides of all lines. All coordinates are multiplied by `scale`.
std::vector<LineLoop> loops_along(std::span<const NetArc> lines, double scale) {
    const std::vector<SideIndex> following = following_sides(lines);
    const std::vector<std::size_t> components = components_of(lines);
    std::vector<bool> used(following.size(), false);
    std::vector<LineLoop> loops;
    for (SideIndex start = 0; start < following.size(); ++start) {
        if (used[start]) {
            continue;
        }
        LineLoop& loop = loops.emplace_back();
        loop.component = components[start / 2];
        for (SideIndex side = start; !used[side]; side = following[side]) {
            used[side] = true;
            const DrawnArc arc = side_of(lines, side);
            loop.sides.push_back(
                {scale * arc.tail, pixel_arc({scale * (arc.head - arc.tail), arc.half_angle})});
        }
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

// The loops of insets as closed chains, in the direction opposite to that of the loops, so that the
// walls are on the left of the chains.
struct Insets {
    std::vector<Chain> chains;
    int unclosed = 0;  // number of loops that are missing because they do not close
};

// A box that contains the arcs of a loop, or of all loops of a component.
struct LoopBox {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = Vec2::Constant(-std::numeric_limits<double>::infinity());

    void include(const LineLoop& loop) {
        for (const ArcLoops::Side& side : loop.sides) {
            // No point of an arc is farther from its tail than the arc is long.
            const Vec2 reach = Vec2::Constant(arc_length(film_arc(side.arc)));
            low = low.cwiseMin(side.tail - reach);
            high = high.cwiseMax(side.tail + reach);
        }
    }
    Disc disc_around() const { return {0.5 * (low + high), 0.5 * (high - low).norm()}; }
    bool meets(const LoopBox& other) const {
        return (low.array() <= other.high.array()).all() &&
               (other.low.array() <= high.array()).all();
    }
};

double area_of(const LineLoop& loop) {
    double area = 0.0;
    for (std::size_t k = 0; k < loop.sides.size(); ++k) {
        const ArcLoops::Side& side = loop.sides[k];
        const ArcLoops::Side& next = loop.sides[(k + 1) % loop.sides.size()];
        area += 0.5 * cross(side.tail, next.tail) + segment_area(film_arc(side.arc));
    }
    return area;
}

// Divides loops into groups whose insets do not depend on each other. A counter-clockwise loop is a
// group of its own if no other component can be inside of it. All other loops are one group.
std::vector<ArcLoops> groups_of(const std::vector<LineLoop>& loops) {
    std::map<std::size_t, LoopBox> boxes;
    for (const LineLoop& loop : loops) {
        boxes[loop.component].include(loop);
    }
    const std::vector<std::pair<std::size_t, LoopBox>> components(boxes.begin(), boxes.end());
    DiscIndex index;
    index.build(components.size(),
                [&](std::size_t k) { return components[k].second.disc_around(); });
    std::vector<ArcLoops> groups(1);
    for (const LineLoop& loop : loops) {
        LoopBox box;
        box.include(loop);
        const auto is_inside = [&](std::size_t k) {
            return components[k].first != loop.component && box.meets(components[k].second);
        };
        const bool is_alone =
            area_of(loop) > 0.0 && std::ranges::none_of(index.near(box.disc_around()), is_inside);
        ArcLoops& group = is_alone ? groups.emplace_back() : groups.front();
        group.sides.insert(group.sides.end(), loop.sides.begin(), loop.sides.end());
        group.loop_ends.push_back(group.sides.size());
    }
    return groups;
}

Insets insets_of(const std::vector<ArcLoops>& groups, double distance, double scale) {
    Insets insets;
    InsetTracer tracer;
    for (const ArcLoops& group : groups) {
        const ArcLoops& found = tracer.trace(group, distance);
        insets.unclosed += found.unclosed_loops;
        for (std::size_t k = 0; k < found.loop_ends.size(); ++k) {
            insets.chains.push_back(reversed_loop(found.loop(k), scale));
        }
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
    const std::vector<ArcLoops> groups = groups_of(loops_along(lines, scale));
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        const double distance = 0.5 * scale * width * (1.0 + attempt * kLargerWidth);
        Insets insets = insets_of(groups, distance, scale);
        if (insets.unclosed == 0) {
            return std::move(insets.chains);
        }
    }
    throw std::invalid_argument(
        "an outline of the walls, or of the solution of a maze, does not close at this width: "
        "choose another vector.wall_width or maze.solution_width");
}

}  // namespace foam::texgen
