// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the text that replaces a placeholder in the file names of a preset. `name` is the part
/// of the placeholder between its braces:
///
///     {preset}         the name of the preset
///     {seed}           the seed, foam.seed
///     {size}           the size of the images in pixels, as in --size: "1024" for a square of 1024
///                      x 1024, otherwise such as "2048x1024"
///     {foam.bubbles}   the value of this key; likewise for every key with a single value
///
/// Numbers are written as short as possible: "0.1", "2". If the value of a key is a text,
/// file_name_part makes it fit for file names.
///
/// Throws std::invalid_argument, with the placeholder in the message, in these cases:
/// - There is no such placeholder.
/// - The key is itself a pattern of file names.
/// - The value is unset, a list, or "auto" in place of a number.
/// - The value is a text of which file_name_part keeps nothing or more than 64 bytes.
std::string placeholder_text(const Preset& preset, std::string_view name);

/// Returns a text in which placeholders in braces, except {map}, have been replaced
/// (placeholder_text). Throws the exceptions of placeholder_text, and std::invalid_argument if a
/// brace is not closed.
std::string with_placeholders_filled(const Preset& preset, std::string_view text);

/// Returns a text that can be a part of a file name on every system. ASCII letters, digits, '.',
/// '_', '-' and all characters beyond ASCII stay. Every run of other characters becomes one '-'.
/// Then '.', '_' and '-' are left out at both ends, so that "#ff8800" becomes "ff8800", and the
/// result is never "..". The result is empty if the text has no letter, no digit and no character
/// beyond ASCII.
std::string file_name_part(std::string_view text);

}  // namespace foam::texgen
