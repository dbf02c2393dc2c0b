// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Stores values in the preset, in order, and then checks the conditions between keys. Throws
/// PresetError at the first value or combination that is not allowed; the preset is then unusable.
void assign(Preset& preset, std::span<const Assignment> assignments);

/// Parses a TOML document. Keys that it does not set keep their defaults. `source` is the name of
/// the document in error messages. Throws PresetError for malformed TOML or an invalid preset.
Preset parse_preset(std::string_view toml, const std::string& name, const std::string& source);

/// Returns the preset as TOML: every key, including those with default values, and the events.
/// parse_preset reads the same preset back.
std::string to_toml(const Preset& preset);

/// Returns the reference documentation of all keys, including keys of events: default, meaning and
/// allowed values.
std::string describe_keys();

/// Returns the part of the reference that is about one table, or about events. Throws PresetError
/// if there is no such table.
std::string describe_table(std::string_view table);

}  // namespace foam::texgen
