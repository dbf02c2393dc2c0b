// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/format.h"

#include "texgen/image/file_suffix.h"
#include "texgen/vector/appearance.h"
#include "texgen/vector/draw.h"
#include "texgen/vector/dxf.h"
#include "texgen/vector/pdf.h"
#include "texgen/vector/svg.h"
#include "texgen/vector/tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kAllTables = "tables";

std::vector<std::string> drawing_parts(const VectorOptions& options,
                                       const std::vector<std::string>& map_names) {
    return {std::string(name_of(shown_content(options, map_names)))};
}

std::vector<std::string> csv_parts(const VectorOptions&, const std::vector<std::string>&) {
    return {kTableNames.begin(), kTableNames.end()};
}

std::vector<std::string> json_parts(const VectorOptions&, const std::vector<std::string>&) {
    return {std::string(kAllTables)};
}

template <std::string (*write)(const Drawing&)>
std::string encode_drawing(const VectorSource& source, std::string_view) {
    Drawing drawing = draw(source.layers,
                           shown_content(source.options, source.map_names),
                           source.maps,
                           source.options);
    drawing.title = source.title;
    drawing.description = source.description;
    return write(drawing);
}

std::string encode_csv(const VectorSource& source, std::string_view part) {
    return to_csv(source.layers, source.maps.albedo, part);
}

std::string encode_json(const VectorSource& source, std::string_view) {
    return to_json(source.layers, source.maps.albedo);
}

constexpr std::array<VectorFormat, 5> kFormats = {{
    {"SVG", ".svg", drawing_parts, encode_drawing<to_svg>},
    {"DXF", ".dxf", drawing_parts, encode_drawing<to_dxf>},
    {"PDF", ".pdf", drawing_parts, encode_drawing<to_pdf>},
    {"CSV", ".csv", csv_parts, encode_csv},
    {"JSON", ".json", json_parts, encode_json},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kMeanings = {{
    {"foam", "bubbles and films as arcs"},
    {"maze", "the walls of the maze as arcs"},
    {"maze_solution", "the walls and the solution of the maze as arcs"},
    {"contour", "the films between levels of pressure as arcs"},
    {"bubbles", "a table of all bubbles"},
    {"films", "a table of all films"},
    {"junctions", "a table of all junctions"},
    {kAllTables, "tables of all bubbles, films and junctions"},
}};

}  // namespace

std::span<const VectorFormat> vector_formats() {
    return kFormats;
}

const VectorFormat* find_vector_format(std::string_view file_name) {
    const auto* const found = std::ranges::find_if(
        kFormats, [&](const VectorFormat& format) { return has_suffix(file_name, format.suffix); });
    return found == kFormats.end() ? nullptr : found;
}

std::string vector_suffixes() {
    std::string suffixes;
    for (std::size_t k = 0; k < kFormats.size(); ++k) {
        const char* const separator = k == 0 ? "" : (k + 1 == kFormats.size() ? " or " : ", ");
        suffixes += fmt::format("{}{}", separator, kFormats[k].suffix);
    }
    return suffixes;
}

bool is_table_part(std::string_view part) {
    return part == kAllTables || std::ranges::find(kTableNames, part) != kTableNames.end();
}

std::string_view meaning_of_part(std::string_view part) {
    const auto* const found =
        std::ranges::find(kMeanings, part, &std::pair<std::string_view, std::string_view>::first);
    return found == kMeanings.end() ? "" : found->second;
}

}  // namespace foam::texgen
