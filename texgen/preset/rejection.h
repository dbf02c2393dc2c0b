// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <initializer_list>
#include <span>
#include <string_view>

namespace foam::texgen {

/// Throws PresetError. The message is one line with location, key, value and the reason.
[[noreturn]] void reject(const Assignment& assignment, std::string_view reason);

/// Rejects the last assignment to any of the keys, because it made a valid preset invalid. If none
/// of the keys is assigned, rejects the last of all assignments. Precondition: there is at least
/// one assignment.
[[noreturn]] void reject_last(std::span<const Assignment> assignments,
                              std::initializer_list<std::string_view> keys,
                              std::string_view reason);

/// Rejects an unknown key or table. `meant` is the most similar known name, or empty.
[[noreturn]] void reject_unknown(const Assignment& assignment, std::string_view meant);

}  // namespace foam::texgen
