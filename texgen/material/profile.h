// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The conventions of an engine, or of a program in which artists edit materials: the maps that it
/// needs, how the channels of the maps are packed, the direction of y in normals, and the names and
/// formats of files. A profile is a TOML document with the keys of presets, and a description in
/// the table [profile]:
///
///     [profile]
///     description = "An engine of our own"
///
///     [image]
///     maps = ["albedo", "normal"]
///
///     [output]
///     pack = ["ORM=occlusion,roughness,metallic"]
///
/// It may set keys of the maps and of the tables preset, image, camera, output, vector and mesh. It
/// may not set keys of the other tables, which change the foam (table_affects_simulation).
struct Profile {
    std::string name;  // name of the shipped profile, or name of the file without ".toml"
    std::string description;
    std::vector<Assignment> assignments;  // of keys of presets
};

/// Returns the profile that a TOML document describes. `source` is the name of the document in
/// messages. Throws PresetError if the document is malformed, or if it sets a key of a table that
/// profiles may not set or an unknown key of the table [profile].
Profile parse_profile(std::string_view toml, std::string name, const std::string& source);

/// Loads the profile in the file with the given path, or the shipped profile with the given name.
/// Paths and names are told apart as for presets (is_preset_path). Throws PresetError if no shipped
/// profile has the name, if the file is missing or unreadable, and for the same reasons as
/// parse_profile. Keys of presets and their values are checked further only when they are assigned
/// to a preset (assign).
Profile load_profile(const std::string& name_or_path);

/// Returns the assignments of a profile, adapted to a preset by two changes:
///
/// - In the profile's values of image.maps, output.pack and output.names, the map albedo is
///   replaced by the map that has the colors of the preset (base_color_map). Only names of maps are
///   replaced: the names of packed images (output.pack) and the words for maps in file names
///   (output.names) stay the same. Nothing is replaced if the profile's image.maps contains both
///   albedo and the map that has the colors of the preset.
/// - The map emission is left out of image.maps if nothing in the preset glows (lit.glow is 0).
std::vector<Assignment> assignments_for(const Profile& profile, const Preset& preset);

/// Returns the assignments of the profile with the given name or path for a preset. The caller then
/// assigns them to the preset, and after them `overrides`, which take precedence. Since overrides
/// may change which map has the colors of the preset and whether anything glows, assignments_for
/// gets a copy of the preset in which they are already assigned. Only image.maps has the value of
/// the preset in this copy, because base_color_map reads it. Throws the exceptions of load_profile,
/// and PresetError if one of the overrides is not allowed.
std::vector<Assignment> profile_assignments(const std::string& profile,
                                            const Preset& preset,
                                            std::span<const Assignment> overrides);

/// Returns the name of the map that has the unlit colors of a preset. This is the first map of
/// colors in image.maps, where the maps emission and id_color do not count. If this first map is
/// `lit`, the result is the map whose colors `lit` shows. If image.maps has no map of colors that
/// counts, the result is "albedo".
std::string base_color_map(const Preset& preset);

}  // namespace foam::texgen
