// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The error of an invalid preset. Its message is one line: location, key, value and what is
/// allowed.
class PresetError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// An unchecked value for a key, and the location of both.
struct Assignment {
    std::string location;  // "sea.toml:12" or "--set foam.seed=3"
    std::string key;       // "foam.seed"; parts are quoted if TOML requires it
    Value value;
};

/// Returns the assignments of a TOML document in the order of its lines. The header of a table
/// gives an assignment, too; its value is a Value::Table. The second [[event]] has the key
/// event[2]. Locations begin with `source`. Throws PresetError for malformed TOML.
std::vector<Assignment> read_assignments(std::string_view toml, const std::string& source);

/// Parses a value from the command line. A text that is not valid TOML becomes a string, so that
/// words need no quotes.
Value read_value(const std::string& text);

/// Parses KEY=VALUE, the argument of `--set`; read_value parses the value. Throws PresetError if
/// there is no key or no '='.
Assignment read_set_argument(const std::string& argument);

}  // namespace foam::texgen
