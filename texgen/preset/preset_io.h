#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Stores values in the preset, in order, and then checks the conditions between keys. Throws
/// PresetError at the first value that is not allowed; the preset is then unusable.
void assign(Preset& preset, std::span<const Assignment> assignments);

/// Parses a TOML document, whose values change the default preset; `source` names it in errors.
/// Throws PresetError.
Preset parse_preset(std::string_view toml, const std::string& name, const std::string& source);

/// Writes every key of the preset, defaults too, and its events. parse_preset reads the same preset
/// back.
std::string to_toml(const Preset& preset);

/// Returns the reference of all keys, those of events too: default, meaning, allowed values.
std::string describe_keys();

/// Returns the part of the reference that is about one table, or about events. Throws PresetError
/// if there is no such table.
std::string describe_table(std::string_view table);

}  // namespace foam::texgen
