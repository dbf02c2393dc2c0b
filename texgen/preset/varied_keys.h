// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/key_values.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Parses an item of preset.vary: a key and the values among which random variations choose
/// (parse_key_values). A range without a count stands for all of its numbers. Throws
/// std::invalid_argument if the text has another form, if there is no such key, if the key is in
/// the table `preset` or `output`, if the key does not allow a value, or if LOW is not below HIGH
/// in a range without a count.
KeyValues parse_varied_key(std::string_view text);

/// Returns the items of preset.vary. Precondition: they have been checked.
std::vector<KeyValues> varied_keys(const Preset& preset);

/// If the assignments set preset.vary, checks its items (parse_varied_key), and that each key
/// occurs only once. Throws PresetError otherwise. Precondition: the assignments have been stored
/// in the preset.
void check_varied_keys(std::span<const Assignment> assignments, const Preset& preset);

/// Returns the number at a fraction from 0 to 1 of a range without a count. It is a whole number if
/// the key takes whole numbers. Except for a seed, it is rounded to a multiple of a power of ten
/// such that the range has 20 to 200 different numbers (or fewer whole numbers), so that preset
/// files are easy to read. Precondition: the key exists and allows `range.low`.
Value number_at(const KeyValues& varied, const NumberRange& range, double fraction);

}  // namespace foam::texgen
