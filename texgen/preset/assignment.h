#pragma once

#include "texgen/preset/value.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A preset that cannot be used; one line with place, key, value and what is allowed.
class PresetError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// One value given to one key, not yet checked, and where that was said.
struct Assignment {
    std::string place;  // "sea.toml:12" or "--set foam.seed=3"
    std::string key;    // "foam.seed"; parts that TOML would quote are quoted
    Value value;
};

/// The assignments of a TOML document in the order of its lines, tables included, with places named
/// after `source`. The second [[event]] comes as the key event[2]. Throws PresetError for malformed
/// TOML.
std::vector<Assignment> read_assignments(std::string_view toml, const std::string& source);

/// A value from the command line: TOML, or else the bare text itself, which saves the quotes of
/// words.
Value read_value(const std::string& text);

/// What follows `--set`: KEY=VALUE, read by read_value. Throws PresetError without a key or a '='.
Assignment read_set_argument(const std::string& argument);

}  // namespace foam::texgen
