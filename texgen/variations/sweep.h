// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// A key and the values that it takes, one after the other.
struct Sweep {
    std::string key;                 // "foam.lloyd"
    std::vector<Assignment> values;  // at least one
};

/// Parses the argument of `--sweep`: KEY=VALUES. VALUES are separated by commas; commas within
/// brackets or quotes do not separate. A value LOW..HIGH:COUNT stands for COUNT evenly spaced
/// numbers, both ends included. Throws PresetError if the argument is malformed or has more than
/// kMaxValues (preset/key_values.h) values. Does not check that the key exists and allows the
/// values; `assign` does.
Sweep read_sweep(const std::string& argument);

/// Returns the sweep of the key foam.seed for the argument of `--seeds`. The argument has the
/// notation that parse_frame_range reads (bake/frame_range.h). Throws PresetError if
/// parse_frame_range rejects the argument, or if there are more than kMaxValues seeds.
Sweep read_seeds(const std::string& argument);

}  // namespace foam::texgen
