#pragma once

#include "texgen/preset/assignment.h"

#include <initializer_list>
#include <span>
#include <string_view>

namespace foam::texgen {

/// Throws PresetError: one line with place, key, value and the reason.
[[noreturn]] void refuse(const Assignment& assignment, std::string_view reason);

/// The same for the last assignment to any of some keys, or else the last of all: the one that made
/// what was good before a bad whole. Precondition: there are assignments.
[[noreturn]] void refuse_last(std::span<const Assignment> assignments,
                              std::initializer_list<std::string_view> keys,
                              std::string_view reason);

/// The same for a key or a table that there is none of; `meant` is the one that comes nearest, or
/// empty.
[[noreturn]] void refuse_unknown(const Assignment& assignment, std::string_view meant);

}  // namespace foam::texgen
