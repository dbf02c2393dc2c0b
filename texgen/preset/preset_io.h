// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Stores the values of the assignments in the preset, in order, and then checks the conditions
/// between keys. Throws PresetError for the first value or combination of values that is not
/// allowed. After an error the preset must not be used.
void assign(Preset& preset, std::span<const Assignment> assignments);

/// Returns the preset of a TOML document. Keys that the document does not set keep their defaults.
/// `name` becomes Preset::name. `source` is the name of the document in error messages. Throws
/// PresetError for malformed TOML or an invalid preset. `extends` is an unknown key here; see
/// load_preset.
Preset parse_preset(std::string_view toml, const std::string& name, const std::string& source);

/// Returns the preset as TOML: every key of its tables, even if the key has its default value, and
/// the events. The key albedo.colors is either a list or a table; the text contains only the one
/// that was set last. The function parse_preset restores an equal preset from the text, except for
/// Preset::name.
std::string to_toml(const Preset& preset);

/// Returns the names of all tables, in the order of preset_keys. The last one is "event".
std::vector<std::string_view> preset_tables();

/// Returns the reference text of all keys, including the keys of events. It gives the default, the
/// meaning and the allowed values of each key.
std::string describe_keys();

/// Returns the part of the reference text (describe_keys) that describes the keys of one table, or
/// the keys of events if `table` is "event". Throws PresetError if the table does not exist.
std::string describe_table(std::string_view table);

}  // namespace foam::texgen
