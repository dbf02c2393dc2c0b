// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>

namespace foam {

/// The newest version of the state format. It is incremented if an older reader could not use a
/// newer file. Foams on a torus without shear are written in version 1; patches and sheared tori
/// need version 2.
inline constexpr int kFoamJsonVersion = 2;

/// Returns the whole state of a foam as JSON, in the foam's own units. README.md specifies the
/// format. A foam that is read back gives the same bits in all later steps. Dead slots are not
/// written. Precondition: all numbers are finite.
std::string write_foam_json(const Foam& foam);

/// Parses a state file. Ignores members that it does not know. Throws FormatError, with `file` as
/// the name in its message, if the text is not JSON, is not a state, has a newer version, or does
/// not describe a valid foam.
Foam read_foam_json(std::string_view text, const std::string& file);

}  // namespace foam
