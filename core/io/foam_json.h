#pragma once

#include "core/foam/foam.h"

#include <string>
#include <string_view>

namespace foam {

/// The newest version of the state format; it grows when an older reader could not go on from a
/// newer file. Foams on a torus are written in version 1, which has no patches.
inline constexpr int kFoamJsonVersion = 2;

/// The whole state of a foam as JSON (README.md has the format), in the foam's own units: what is
/// read back steps to the same bits. Dead slots are closed first, as by `compact`. Precondition:
/// finite numbers.
std::string write_foam_json(const Foam& foam);

/// The foam of a state file. Members it does not know are passed over. Throws FormatError, in the
/// name of `file`, where the text is no JSON, no state, of a newer version, or holds no valid foam.
Foam read_foam_json(std::string_view text, const std::string& file);

}  // namespace foam
