#pragma once

#include "texgen/preset/assignment.h"

#include <string_view>

namespace foam::texgen {

/// Throws PresetError: one line with place, key, value and the reason.
[[noreturn]] void refuse(const Assignment& assignment, std::string_view reason);

/// The same for a key or a table that there is none of; `meant` is the one that comes nearest, or
/// empty.
[[noreturn]] void refuse_unknown(const Assignment& assignment, std::string_view meant);

}  // namespace foam::texgen
