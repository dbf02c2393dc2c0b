#pragma once

#include "texgen/keys/value.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// An invalid preset; one line with location, key, value and what is allowed.
class PresetError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// A value given to a key, not yet checked, and its location.
struct Assignment {
    std::string location;  // "sea.toml:12" or "--set foam.seed=3"
    std::string key;       // "foam.seed"; parts that TOML would quote are quoted
    Value value;
};

/// Returns the assignments of a TOML document in the order of its lines, tables included. Locations
/// are named after `source`. The second [[event]] has the key event[2]. Throws PresetError for
/// malformed TOML.
std::vector<Assignment> read_assignments(std::string_view toml, const std::string& source);

/// Parses a value from the command line: TOML, or else the text itself, so that words need no
/// quotes.
Value read_value(const std::string& text);

/// Parses the argument of `--set`, KEY=VALUE, by read_value. Throws PresetError without a key or
/// a '='.
Assignment read_set_argument(const std::string& argument);

}  // namespace foam::texgen
