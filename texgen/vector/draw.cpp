// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/draw.h"

#include "core/foam/measure.h"
#include "texgen/image/color.h"
#include "texgen/maps/cell_color.h"
#include "texgen/vector/appearance.h"
#include "texgen/vector/foam_layout.h"
#include "texgen/vector/net_nodes.h"
#include "texgen/vector/number_text.h"
#include "texgen/vector/solution_arcs.h"
#include "texgen/vector/tile_copies.h"
#include "texgen/vector/tile_cut.h"
#include "texgen/vector/wall_outlines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace foam::texgen {

namespace {

// The lines of one layer of a drawing. If they are cut at the border of the tile of a torus:
// - `lines` contains their parts, moved into the tile;
// - `near_lines` contains whole copies of all lines that touch the tile if drawn with their width;
// - `parts_beyond` contains the parts of these copies outside of the tile.
//
// If the lines are not cut, `near_lines` equals `lines`, and `parts_beyond` is empty. films_work
// fills only the members that are drawn: `near_lines` if walls are drawn as outlines, `lines` and
// `parts_beyond` if they are drawn as lines.
struct LineWork {
    std::string layer;  // name of the layer
    std::string kind;   // class of the shapes in an SVG (Shape::kind)
    std::string color;
    double width = 0.0;  // millimeters
    bool is_cut = false;
    std::vector<NetArc> lines{};
    std::vector<NetArc> near_lines{};
    std::vector<DrawnArc> parts_beyond{};
};

// Adds each chain of lines as a shape.
void add_chains(const LineWork& work,
                const std::string& name,
                bool is_beyond_tile,
                const std::vector<Chain>& chains,
                Drawing& drawing) {
    Layer layer{.name = name,
                .style = {.stroke = work.color, .stroke_width = work.width},
                .is_tool_path = !is_beyond_tile,
                .is_beyond_tile = is_beyond_tile};
    for (const Chain& chain : chains) {
        layer.shapes.push_back({.kind = work.kind, .chains = {chain}});
    }
    drawing.layers.push_back(std::move(layer));
}

void add_lines(const LineWork& work, Drawing& drawing) {
    if (!work.parts_beyond.empty() && work.width > 0.0) {
        std::vector<Chain> parts;
        for (const DrawnArc& arc : work.parts_beyond) {
            parts.push_back(chain_of(std::span(&arc, 1), false));
        }
        add_chains(work, work.layer + "_beyond", true, parts, drawing);
    }
    add_chains(work, work.layer, false, joined(work.lines), drawing);
}

void add_outlines(const LineWork& work, Drawing& drawing) {
    std::vector<Chain> outlines = wall_outlines(work.near_lines, work.width);
    if (work.is_cut) {
        outlines = clipped_to_tile(outlines, drawing.width, drawing.height);
    }
    drawing.layers.push_back({.name = work.layer,
                              .style = {.fill = work.color},
                              .shapes = {{.kind = work.kind, .chains = std::move(outlines)}},
                              .is_tool_path = true});
}

void add_work(const LineWork& work, VectorWalls walls, Drawing& drawing) {
    if (walls == VectorWalls::Lines) {
        add_lines(work, drawing);
    } else {
        add_outlines(work, drawing);
    }
}

LineWork films_work(const Appearance& look,
                    const FoamLayout& layout,
                    const Page& page,
                    const VectorOptions& options) {
    const double width = drawn_width(look, page, options);
    LineWork work{.layer = look.layer,
                  .kind = look.kind,
                  .color = look.line_color,
                  .width = width,
                  .is_cut = layout.is_cut()};
    if (options.walls == VectorWalls::Lines) {
        work.lines = layout.lines(look.has_line);
        work.parts_beyond = layout.lines_beyond_tile(look.has_line, width);
    } else {
        work.near_lines = layout.lines_near_tile(look.has_line, width);
    }
    return work;
}

// The number of biarcs (smooth_arcs) between two successive films that the solution of a maze
// crosses. With four, the arcs differ from the line that the map `maze_solution` shows by less than
// a hundredth of the width of this line.
constexpr int kPiecesPerStation = 4;

// Adds an arc of the solution of a maze to `work`. The arc connects the points `k` and k + 1 of the
// solution.
void add_solution_arc(
    const DrawnArc& arc, std::size_t k, const Page& page, NetNodes& nodes, LineWork& work) {
    if (page.domain.is_plane()) {
        work.lines.push_back({arc, nodes.node_of(k, {}), nodes.node_of(k + 1, {})});
        work.near_lines.push_back(work.lines.back());
        return;
    }
    const std::vector<CellPiece> pieces = cut_at_cells(arc, page.domain);
    for (std::size_t m = 0; m < pieces.size(); ++m) {
        // A cell is the tile or a periodic copy of the tile. If a point is on the border of a cell,
        // the two arcs that meet there may be in different cells. Moved into the tile, they then
        // end on opposite sides.
        const LatticeOffset cell = pieces[m].cell;
        const std::uint64_t tail = m == 0 ? nodes.node_of(k, cell) : nodes.unshared_node();
        const std::uint64_t head =
            m + 1 == pieces.size() ? nodes.node_of(k + 1, cell) : nodes.unshared_node();
        work.lines.push_back({pieces[m].arc, tail, head});
    }
    for (const ArcCopy& copy : copies_near_tile(arc, page, work.width)) {
        work.near_lines.push_back(
            {copy.arc, nodes.node_of(k, copy.offset), nodes.node_of(k + 1, copy.offset)});
    }
    std::ranges::copy(parts_beyond_tile(arc, page, work.width),
                      std::back_inserter(work.parts_beyond));
}

LineWork solution_work(FrameLayers& layers, const MazeOptions& options, const Page& page) {
    const double width =
        diameters_in_pixels(options.solution_width, layers.grid(), layers.frame().domain);
    LineWork work{.layer = "solution",
                  .kind = "solution",
                  .color = options.solution_color,
                  .width = width * page.pixel,
                  .is_cut = !page.domain.is_plane()};
    const Maze& maze = layers.maze(maze_rule(options));
    if (!maze.solution.empty()) {
        const auto stations = solution_stations(layers.frame(), maze.solution);
        const auto arcs = smooth_arcs(refined(stations, kPiecesPerStation), page);
        NetNodes nodes;
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            add_solution_arc(arcs[k], k, page, nodes, work);
        }
    }
    return work;
}

using Data = std::vector<std::pair<std::string, std::string>>;

Data data_of(const Frame& frame, BubbleId id) {
    const FrameBubble& bubble = frame.bubbles[id];
    return {{"bubble", fmt::format("{}", bubble.identity)},
            {"area", exact_text(bubble.area)},
            {"sides", fmt::format("{}", frame.network.sides(id))},
            {"pressure", exact_text(bubble.pressure)}};
}

Data data_of(const Frame& frame, const LoneBubble& bubble) {
    return {{"bubble", fmt::format("{}", bubble.identity)},
            {"area", exact_text(bubble.target_area)},
            {"sides", "0"},
            {"pressure", exact_text(lone_pressure(bubble, frame.film_tension))}};
}

// Adds one shape per bubble, in the color that the bubble has in the map `albedo`.
void add_bubbles(const FrameLayers& layers,
                 const AlbedoOptions& options,
                 const FoamLayout& layout,
                 Drawing& drawing) {
    const Frame& frame = layers.frame();
    const PerBubble<std::string> colors = bubble_colors(layers, options);
    PerBubble<std::vector<Chain>> outlines = layout.bubbles();
    const PerBubble<Data> data = per_bubble<Data>(
        frame,
        [&](BubbleId bubble) { return data_of(frame, bubble); },
        [&](const LoneBubble& bubble) { return data_of(frame, bubble); });
    Layer layer{.name = "bubbles"};
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        layer.shapes.push_back({.kind = "bubble",
                                .id = "bubble-" + data[k].front().second,
                                .chains = std::move(outlines[k]),
                                .fill = colors[k],
                                .data = data[k]});
    }
    drawing.layers.push_back(std::move(layer));
}

// Colors the ground under the lines. If the tile cuts the bubbles, the ground is the whole drawing.
// Otherwise, the ground is one shape of all bubbles, so that there are no seams between bubbles.
void add_ground(const std::string& color, const FoamLayout& layout, Drawing& drawing) {
    if (layout.is_cut()) {
        drawing.background = color;
        return;
    }
    Shape ground{.kind = "passage", .chains = {}};
    for (const std::vector<Chain>& outlines : layout.bubbles()) {
        std::ranges::copy(outlines, std::back_inserter(ground.chains));
    }
    drawing.layers.push_back(
        {.name = "passages", .style = {.fill = color}, .shapes = {std::move(ground)}});
}

// Returns a box around the tile and all shapes, with the whole width of their lines.
Box box_around(const Drawing& drawing) {
    Box box{{0.0, 0.0}, {drawing.width, drawing.height}};
    double width = 0.0;
    for (const Layer& layer : drawing.layers) {
        width = std::max(width, layer.style.stroke_width);
        for (const Shape& shape : layer.shapes) {
            for (const Chain& chain : shape.chains) {
                include(chain, box);
            }
        }
    }
    return {box.low - Vec2::Constant(0.5 * width), box.high + Vec2::Constant(0.5 * width)};
}

}  // namespace

PerBubble<std::string> bubble_colors(const FrameLayers& layers, const AlbedoOptions& options) {
    PerBubble<std::string> colors;
    for (const LinearRgb& color :
         cell_colors(layers.frame(), layers.record(), options, layers.first())) {
        colors.push_back(color_text(to_srgb8(color)));
    }
    return colors;
}

Drawing draw(FrameLayers& layers,
             VectorContent content,
             const MapOptions& maps,
             const VectorOptions& options) {
    check_width(content, maps, options);
    const Frame& frame = layers.frame();
    const Page page = page_of(frame.domain, layers.grid(), options.width_mm);
    const FoamLayout layout(frame, page, options.wrap);
    const Appearance look = appearance_of(layers, content, maps);
    Drawing drawing{.width = page.width, .height = page.height, .scale = page.scale};
    if (look.ground_color.empty()) {
        add_bubbles(layers, maps.albedo, layout, drawing);
    } else {
        add_ground(look.ground_color, layout, drawing);
    }
    add_work(films_work(look, layout, page, options), options.walls, drawing);
    if (content == VectorContent::MazeSolution) {
        add_work(solution_work(layers, maps.maze, page), options.walls, drawing);
    }
    drawing.junctions = layout.junctions();
    if (options.wrap == VectorWrap::Whole && !page.domain.is_plane()) {
        drawing.extended = box_around(drawing);
    }
    return drawing;
}

}  // namespace foam::texgen
