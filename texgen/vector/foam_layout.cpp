// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/foam_layout.h"

#include "core/foam/measure.h"
#include "texgen/vector/net_nodes.h"
#include "texgen/vector/tile_copies.h"
#include "texgen/vector/tile_cut.h"

#include <cstdint>
#include <map>
#include <tuple>

namespace foam::texgen {

FoamLayout::FoamLayout(const Frame& frame, const Page& page, VectorWrap wrap)
    : frame_(frame), page_(page), is_cut_(!page.domain.is_plane() && wrap == VectorWrap::Cut) {}

// Returns the outline of a bubble. The first corner is at its position in the fundamental cell.
Chain FoamLayout::whole_bubble(BubbleId bubble) const {
    std::vector<DrawnArc> arcs;
    for (const HalfEdgeId h : frame_.network.around(bubble)) {
        DrawnArc arc = arc_on(page_, frame_, h);
        if (!arcs.empty()) {
            arc = moved_by(arc, arcs.back().head - arc.tail);
        }
        arcs.push_back(arc);
    }
    arcs.back().head = arcs.front().tail;
    return chain_of(arcs, true);
}

// Returns the lattice offset from the copy of a bubble that whole_bubble() returns to the copy that
// is drawn: the one whose centroid is in the tile.
LatticeOffset FoamLayout::drawn_offset(BubbleId bubble) const {
    return -page_.domain.cell_of(centroid(whole_bubble(bubble)));
}

PerBubble<std::vector<Chain>> FoamLayout::bubbles() const {
    return per_bubble<std::vector<Chain>>(
        frame_,
        [&](BubbleId bubble) -> std::vector<Chain> {
            Chain outline = whole_bubble(bubble);
            if (is_cut_) {
                return closed_in_cells(outline, page_.domain);
            }
            const Vec2 translation = page_.domain.translation(drawn_offset(bubble));
            outline.tail += translation;
            for (Chain::Step& step : outline.steps) {
                step.head += translation;
            }
            return {outline};
        },
        [&](const LoneBubble& bubble) -> std::vector<Chain> {
            return {circle(page_(bubble.center), page_.scale * lone_radius(bubble))};
        });
}

void FoamLayout::add_lone_bubbles(std::vector<NetArc>& lines) const {
    std::uint64_t node = std::uint64_t{3} << 62;  // above all nodes of NetNodes
    for (const LoneBubble& bubble : frame_.lone_bubbles) {
        const Chain outline = circle(page_(bubble.center), page_.scale * lone_radius(bubble));
        const std::vector<DrawnArc> arcs = arcs_of(outline);
        lines.push_back({arcs[0], node, node + 1});
        lines.push_back({arcs[1], node + 1, node});
        node += 2;
    }
}

// Returns the parts into which the borders of the tile and of its periodic copies (the cells) cut
// the chosen films, moved into the tile. Each end that a cut makes has a node of its own, which no
// other arc shares.
std::vector<NetArc> FoamLayout::cut_lines(const FilmFilter& is_chosen) const {
    NetNodes nodes;
    std::vector<NetArc> lines;
    for (const FilmId film : frame_.network.films()) {
        if (!is_chosen(film)) {
            continue;
        }
        const HalfEdgeId side = forward_side(film);
        const auto pieces = cut_at_cells(arc_on(page_, frame_, side), page_.domain);
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const LatticeOffset cell = pieces[k].cell;
            // If a junction is on the border, the part that ends at it may be in the neighboring
            // cell. Moved into the tile, this part ends on the opposite side, and therefore does
            // not share the node of the junction.
            const bool shares_tail = k == 0 && cell == LatticeOffset{};
            const bool shares_head = k + 1 == pieces.size() && cell == frame_.network.offset(side);
            lines.push_back(
                {pieces[k].arc,
                 shares_tail ? nodes.node_of(frame_.network.tail(side), {}) : nodes.unshared_node(),
                 shares_head ? nodes.node_of(frame_.network.head(side), {})
                             : nodes.unshared_node()});
        }
    }
    return lines;
}

// Returns the chosen films around all bubbles. Each bubble is drawn whole, moved by drawn_offset.
// No film occurs twice at the same position.
std::vector<NetArc> FoamLayout::whole_lines(const FilmFilter& is_chosen) const {
    NetNodes nodes;
    std::map<std::tuple<std::size_t, std::int32_t, std::int32_t>, bool> drawn;
    std::vector<NetArc> lines;
    for (const BubbleId bubble : frame_.network.bubbles()) {
        LatticeOffset tail_offset = drawn_offset(bubble);
        for (const HalfEdgeId h : frame_.network.around(bubble)) {
            const LatticeOffset head_offset = tail_offset + frame_.network.offset(h);
            const LatticeOffset& film_offset = is_forward(h) ? tail_offset : head_offset;
            const FilmId film = film_of(h);
            if (is_chosen(film) &&
                drawn.try_emplace({index_of(film), film_offset.i, film_offset.j}, true).second) {
                lines.push_back(
                    {moved_by(arc_on(page_, frame_, h), page_.domain.translation(tail_offset)),
                     nodes.node_of(frame_.network.tail(h), tail_offset),
                     nodes.node_of(frame_.network.head(h), head_offset)});
            }
            tail_offset = head_offset;
        }
    }
    return lines;
}

std::vector<NetArc> FoamLayout::lines(const FilmFilter& is_chosen) const {
    std::vector<NetArc> lines = is_cut_ ? cut_lines(is_chosen) : whole_lines(is_chosen);
    add_lone_bubbles(lines);
    return lines;
}

std::vector<NetArc> FoamLayout::lines_near_tile(const FilmFilter& is_chosen, double reach) const {
    if (!is_cut_) {
        return lines(is_chosen);
    }
    NetNodes nodes;
    std::vector<NetArc> lines;
    for (const FilmId film : frame_.network.films()) {
        if (!is_chosen(film)) {
            continue;
        }
        const HalfEdgeId side = forward_side(film);
        for (const auto& [arc, offset] :
             copies_near_tile(arc_on(page_, frame_, side), page_, reach)) {
            lines.push_back(
                {arc,
                 nodes.node_of(frame_.network.tail(side), offset),
                 nodes.node_of(frame_.network.head(side), offset + frame_.network.offset(side))});
        }
    }
    return lines;
}

std::vector<DrawnArc> FoamLayout::lines_beyond_tile(const FilmFilter& is_chosen,
                                                    double reach) const {
    std::vector<DrawnArc> beyond;
    if (!is_cut_) {
        return beyond;
    }
    for (const FilmId film : frame_.network.films()) {
        if (is_chosen(film)) {
            const auto parts =
                parts_beyond_tile(arc_on(page_, frame_, forward_side(film)), page_, reach);
            beyond.insert(beyond.end(), parts.begin(), parts.end());
        }
    }
    return beyond;
}

std::vector<Vec2> FoamLayout::junctions() const {
    std::vector<Vec2> positions;
    for (const JunctionId junction : frame_.network.junctions()) {
        positions.push_back(page_(frame_.positions[junction]));
    }
    return positions;
}

}  // namespace foam::texgen
