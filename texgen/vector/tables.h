// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_layers.h"

#include <array>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The names of the tables of a frame. VECTOR_FILES.md explains their columns.
inline constexpr std::array<std::string_view, 3> kTableNames = {"bubbles", "films", "junctions"};

/// Returns one of the tables of a frame as CSV. The first line contains the names of the columns.
/// Lengths are in foam units, y points up. Numbers are written without loss of precision. Cells
/// without a value are empty, such as the bubble on the outer side of a film at the rim of a patch.
/// For the table "bubbles", throws as bubble_colors (draw.h) does. Precondition: `table` is in
/// kTableNames.
std::string to_csv(const FrameLayers& layers, const AlbedoOptions& options, std::string_view table);

/// Returns all tables of a frame as a JSON object: an array of objects for each table, and members
/// that describe the frame. Cells without a value are null. Throws as bubble_colors does.
std::string to_json(const FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
