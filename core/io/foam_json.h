// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>

namespace foam {

/// The newest version of the state format. It is incremented if an older reader would misread a
/// newer file. A foam on a torus without shear is written in version 1, a patch or a sheared torus
/// in version 2.
inline constexpr int kFoamJsonVersion = 2;

/// Returns the whole state of a foam as JSON, in the foam's own units. core/io/README.md specifies
/// the format. A foam that is written and read again evolves exactly like the original, bit for
/// bit. Dead slots and the list of topology events are not written. Precondition: all numbers are
/// finite, except the target area of the ghost, which is not written.
std::string write_foam_json(const Foam& foam);

/// Parses a state file and returns the foam. Ignores unknown members. Throws FormatError if the
/// text is not JSON, is not a state, has a version above kFoamJsonVersion, or does not describe a
/// valid foam. The message begins with `file` as the name of the file.
Foam read_foam_json(std::string_view text, const std::string& file);

}  // namespace foam
