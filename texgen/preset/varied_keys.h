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
/// (parse_key_values). A range without a count, LOW..HIGH, stands for all numbers from LOW to HIGH.
///
/// Throws std::invalid_argument in these cases:
/// - The text has another form.
/// - There is no such key, or the key is in the table `preset` or `output`.
/// - The key does not allow one of the values.
/// - LOW is not below HIGH in a range without a count.
KeyValues parse_varied_key(std::string_view text);

/// Returns the items of preset.vary. Precondition: they have been checked.
std::vector<KeyValues> varied_keys(const Preset& preset);

/// If the assignments set preset.vary, throws PresetError unless its items are valid
/// (parse_varied_key) and each key occurs only once. Precondition: the assignments have been stored
/// in the preset.
void check_varied_keys(std::span<const Assignment> assignments, const Preset& preset);

/// Returns the number at a position in a range without a count. `fraction` is the position, from 0
/// at range.low to 1 at range.high. The result is a whole number if the key takes whole numbers.
/// Unless the key is foam.seed, the number is rounded to a multiple of a power of ten, so that
/// preset files are easy to read. The power is chosen such that the range has 20 to 200 such
/// multiples; a narrow range of whole numbers has fewer. Precondition: the key exists and allows
/// range.low.
Value number_at(const KeyValues& varied, const NumberRange& range, double fraction);

}  // namespace foam::texgen
