#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Puts checked values into the preset, in order. The limits that tie keys together are checked
/// once all are in. Throws PresetError at the first value that is not allowed; the preset is then
/// unusable.
void assign(Preset& preset, std::span<const Assignment> assignments);

/// The default preset changed by a TOML document; `source` names it in errors. Throws PresetError.
Preset parse_preset(std::string_view toml, const std::string& name, const std::string& source);

/// Every key of the preset, defaults too, and its events; parse_preset makes the same preset of it.
std::string to_toml(const Preset& preset);

/// The reference of all keys, those of events too: default, allowed values, meaning.
std::string describe_keys();

}  // namespace foam::texgen
