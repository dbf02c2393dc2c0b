// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The error of an invalid TOML file: a preset, a profile, a job file, or tolerances for `compare`.
/// It is also the error of arguments of the command line that name presets or set their keys. The
/// message is one line. For a value that is not allowed, it contains the location, the key, the
/// value and the allowed values.
class PresetError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// A value for a key, before it is checked, and the location where both were given.
struct Assignment {
    std::string location;  // "sea.toml:12" or "--set foam.seed=3"
    std::string key;       // "foam.seed"; parts are quoted if TOML requires it
    Value value;
};

/// Returns the assignments of a TOML document in the order of the document. A table also gives an
/// assignment, whose value is a Value::Table. The key of the second table [[event]] is event[2].
/// Locations are `source`, a colon and the line. Throws PresetError for malformed TOML, and for
/// keys of more than 32 parts.
std::vector<Assignment> read_assignments(std::string_view toml, const std::string& source);

/// Returns the index of the last character of the TOML string that begins with the quote at index
/// `begin`. This is the last closing quote of the string. A string that is not closed ends with the
/// last character of the line or, if it begins with three quotes, of the text.
std::size_t end_of_string(std::string_view toml, std::size_t begin);

/// Parses a value from the command line. A text that is not a TOML value becomes a string, so that
/// words need no quotes. A table also becomes a string: only documents have tables.
Value read_value(const std::string& text);

/// Parses KEY=VALUE, the argument of `--set`. The value is parsed by read_value. Throws PresetError
/// if the key or the '=' is missing, or if the argument is not UTF-8.
Assignment read_set_argument(const std::string& argument);

}  // namespace foam::texgen
