// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/tables.h"

#include "core/foam/measure.h"
#include "texgen/vector/draw.h"
#include "texgen/vector/foam_layout.h"
#include "texgen/vector/number_text.h"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// A table whose cells are JSON values: numbers, strings or null.
struct Table {
    std::string_view name;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

constexpr const char* kNoValue = "null";

std::string integer_text(std::uint64_t number) {
    return fmt::format("{}", number);
}

// Returns a page in foam units. Positions on it equal positions in the foam.
Page foam_page(const Domain& domain) {
    return {domain.width, domain.height, 1.0, 1.0, Vec2(0.0, 0.0), domain};
}

Table bubble_table(const FrameLayers& layers, const AlbedoOptions& options) {
    Table table{
        "bubbles", {"bubble", "x", "y", "area", "target_area", "pressure", "sides", "color"}, {}};
    const Frame& frame = layers.frame();
    const PerBubble<std::string> colors = bubble_colors(layers, options);
    const auto outlines = FoamLayout(frame, foam_page(frame.domain), VectorWrap::Whole).bubbles();
    const auto add = [&](const FrameBubble& bubble, int sides) {
        const std::size_t k = table.rows.size();
        const Vec2 center = centroid(outlines[k].front());
        table.rows.push_back({integer_text(bubble.identity),
                              exact_text(center.x()),
                              exact_text(center.y()),
                              exact_text(bubble.area),
                              exact_text(bubble.target_area),
                              exact_text(bubble.pressure),
                              fmt::format("{}", sides),
                              "\"" + colors[k] + "\""});
    };
    for (const BubbleId bubble : frame.network.bubbles()) {
        add(frame.bubbles[bubble], frame.network.sides(bubble));
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        add({bubble.identity,
             bubble.target_area,
             bubble.target_area,
             lone_pressure(bubble, frame.film_tension)},
            0);
    }
    return table;
}

// Returns the identity of a bubble, or null for the ghost.
std::string bubble_text(const Frame& frame, BubbleId bubble) {
    return bubble == frame.network.ghost() ? kNoValue
                                           : integer_text(frame.bubbles[bubble].identity);
}

Table film_table(const Frame& frame) {
    Table table{"films",
                {"film",
                 "tail",
                 "head",
                 "x",
                 "y",
                 "chord_x",
                 "chord_y",
                 "half_angle",
                 "curvature",
                 "length",
                 "left",
                 "right"},
                {}};
    for (const FilmId film : frame.network.films()) {
        const HalfEdgeId side = forward_side(film);
        const Vec2& tail = frame.positions[frame.network.tail(side)];
        const FilmArc& arc = frame.arcs[film];
        table.rows.push_back({integer_text(index_of(film)),
                              integer_text(index_of(frame.network.tail(side))),
                              integer_text(index_of(frame.network.head(side))),
                              exact_text(tail.x()),
                              exact_text(tail.y()),
                              exact_text(arc.chord.x()),
                              exact_text(arc.chord.y()),
                              exact_text(arc.half_angle),
                              exact_text(curvature(arc)),
                              exact_text(arc_length(arc)),
                              bubble_text(frame, frame.network.left(side)),
                              bubble_text(frame, frame.network.right(side))});
    }
    return table;
}

Table junction_table(const Frame& frame) {
    Table table{"junctions", {"junction", "x", "y", "film_1", "film_2", "film_3"}, {}};
    for (const JunctionId junction : frame.network.junctions()) {
        const Vec2& position = frame.positions[junction];
        std::vector<std::string> row = {
            integer_text(index_of(junction)), exact_text(position.x()), exact_text(position.y())};
        for (const HalfEdgeId side : frame.network.leaving(junction)) {
            row.push_back(integer_text(index_of(film_of(side))));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table table_of(const FrameLayers& layers, const AlbedoOptions& options, std::string_view name) {
    if (name == kTableNames[0]) {
        return bubble_table(layers, options);
    }
    return name == kTableNames[1] ? film_table(layers.frame()) : junction_table(layers.frame());
}

// Returns a cell as CSV: without quotes, and empty if it has no value. No cell contains a comma.
std::string csv_cell(const std::string& cell) {
    if (cell == kNoValue) {
        return "";
    }
    return cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        line += (k == 0 ? "" : ",") + csv_cell(cells[k]);
    }
    return line + "\n";
}

std::string json_row(const Table& table, const std::vector<std::string>& row) {
    std::string text;
    for (std::size_t k = 0; k < row.size(); ++k) {
        text += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", table.columns[k], row[k]);
    }
    return "    {" + text + "}";
}

std::string json_rows(const Table& table) {
    std::string text;
    for (const std::vector<std::string>& row : table.rows) {
        text += (text.empty() ? "\n" : ",\n") + json_row(table, row);
    }
    return fmt::format("  \"{}\": [{}\n  ]", table.name, text);
}

// Returns the periods of a torus, or null for the plane.
std::string json_domain(const Domain& domain) {
    if (domain.is_plane()) {
        return kNoValue;
    }
    return fmt::format("{{\"width\": {}, \"height\": {}, \"shear\": {}}}",
                       exact_text(domain.width),
                       exact_text(domain.height),
                       exact_text(domain.shear));
}

}  // namespace

std::string to_csv(const FrameLayers& layers,
                   const AlbedoOptions& options,
                   std::string_view table) {
    const Table found = table_of(layers, options, table);
    std::string text = csv_line(found.columns);
    for (const std::vector<std::string>& row : found.rows) {
        text += csv_line(row);
    }
    return text;
}

std::string to_json(const FrameLayers& layers, const AlbedoOptions& options) {
    const Frame& frame = layers.frame();
    std::string text = fmt::format(
        "{{\n  \"format\": \"foamtex-frame\",\n  \"version\": 1,\n  \"frame\": {},\n"
        "  \"time\": {},\n  \"domain\": {},\n  \"film_tension\": {}",
        frame.number,
        exact_text(frame.time),
        json_domain(frame.domain),
        exact_text(frame.film_tension));
    for (const std::string_view name : kTableNames) {
        text += ",\n" + json_rows(table_of(layers, options, name));
    }
    return text + "\n}\n";
}

}  // namespace foam::texgen
