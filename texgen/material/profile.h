// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The conventions of an engine or a program for materials. They say which maps the engine needs,
/// and how the channels of the maps are packed. They also set the direction of y in normals, and
/// the names and formats of files. A profile is a TOML document with the keys of presets, and a
/// description in the table [profile]:
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
/// It may set all keys except those that change the foam (table_affects_simulation).
struct Profile {
    std::string name;  // name of the shipped profile, or name of the file without ".toml"
    std::string description;
    std::vector<Assignment> assignments;  // of keys of presets
};

/// Returns the profile that a TOML document describes. `source` is the name of the document in
/// messages. Throws PresetError if the document is malformed, or if it sets a key that changes the
/// foam or an unknown key of the table [profile].
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
///   (output.names) stay the same.
/// - The map emission is left out of image.maps if nothing in the preset glows (lit.glow is 0).
std::vector<Assignment> assignments_for(const Profile& profile, const Preset& preset);

/// Returns the assignments of the profile with the given name or path for a preset. `overrides` are
/// further assignments, which will be made after the result has been assigned. The result is
/// computed by assignments_for from a copy of the preset in which the overrides have been assigned.
/// Only image.maps, which base_color_map reads, keeps its value in the copy. Throws the exceptions
/// of load_profile, and PresetError if one of the overrides is not allowed.
std::vector<Assignment> profile_assignments(const std::string& profile,
                                            const Preset& preset,
                                            std::span<const Assignment> overrides);

/// Returns the name of the map that has the unlit colors of a preset. This is the first map of
/// colors in image.maps, apart from emission and id_color. If that first map is `lit`, the result
/// is the map whose colors `lit` shows. If image.maps has no such map, the result is "albedo".
std::string base_color_map(const Preset& preset);

}  // namespace foam::texgen
