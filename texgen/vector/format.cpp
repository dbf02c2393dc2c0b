// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/format.h"

#include "texgen/image/file_suffix.h"
#include "texgen/mesh/glb_mesh.h"
#include "texgen/mesh/stl.h"
#include "texgen/vector/appearance.h"
#include "texgen/vector/draw.h"
#include "texgen/vector/dxf.h"
#include "texgen/vector/frame_mesh.h"
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

std::vector<std::string> drawing_parts(const VectorSettings& settings) {
    return {std::string(name_of(shown_content(settings.drawing, settings.map_names)))};
}

std::vector<std::string> csv_parts(const VectorSettings&) {
    return {kTableNames.begin(), kTableNames.end()};
}

std::vector<std::string> json_parts(const VectorSettings&) {
    return {std::string(kAllTables)};
}

std::vector<std::string> mesh_parts(const VectorSettings& settings) {
    return {shown_kind(settings) == MeshKind::Relief ? "relief" : "walls"};
}

void check_drawing(const VectorSettings& settings) {
    check_width(
        shown_content(settings.drawing, settings.map_names), settings.maps, settings.drawing);
}

void check_table(const VectorSettings&) {}

template <std::string (*write)(const Drawing&)>
std::string encode_drawing(const VectorSource& source, std::string_view) {
    const VectorSettings& settings = source.settings;
    Drawing drawing = draw(source.layers,
                           shown_content(settings.drawing, settings.map_names),
                           settings.maps,
                           settings.drawing);
    drawing.title = source.title;
    drawing.description = source.description;
    return write(drawing);
}

template <std::string (*write)(const Mesh&, std::string_view)>
std::string encode_mesh(const VectorSource& source, std::string_view) {
    return write(frame_mesh(source), source.title);
}

template <bool is_glb>
MeshEstimate estimate_mesh(const VectorSettings& settings, int bubbles) {
    return estimated_mesh(settings, bubbles, is_glb);
}

std::string encode_csv(const VectorSource& source, std::string_view part) {
    return to_csv(source.layers, source.settings.maps.albedo, part);
}

std::string encode_json(const VectorSource& source, std::string_view) {
    return to_json(source.layers, source.settings.maps.albedo);
}

constexpr std::array<VectorFormat, 7> kFormats = {{
    {"SVG", ".svg", "millimeters", drawing_parts, check_drawing, encode_drawing<to_svg>},
    {"DXF", ".dxf", "millimeters", drawing_parts, check_drawing, encode_drawing<to_dxf>},
    {"PDF", ".pdf", "millimeters", drawing_parts, check_drawing, encode_drawing<to_pdf>},
    {"CSV", ".csv", "foam units", csv_parts, check_table, encode_csv},
    {"JSON", ".json", "foam units", json_parts, check_table, encode_json},
    {"STL",
     ".stl",
     "millimeters",
     mesh_parts,
     check_mesh,
     encode_mesh<to_stl>,
     estimate_mesh<false>},
    {"GLB", ".glb", "meters", mesh_parts, check_mesh, encode_mesh<to_glb>, estimate_mesh<true>},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kMeanings = {{
    {"foam", "bubbles and films as arcs"},
    {"maze", "the walls of the maze as arcs"},
    {"maze_solution", "the walls and the solution of the maze as arcs"},
    {"contour", "the films between levels of pressure, and the outline of a patch, as arcs"},
    {"bubbles", "a table of all bubbles"},
    {"films", "a table of all films"},
    {"junctions", "a table of all junctions"},
    {"relief", "the relief as a closed mesh"},
    {"walls", "walls as a closed mesh"},
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

std::string_view meaning_of_part(std::string_view part) {
    const auto* const found =
        std::ranges::find(kMeanings, part, &std::pair<std::string_view, std::string_view>::first);
    return found == kMeanings.end() ? "" : found->second;
}

}  // namespace foam::texgen
