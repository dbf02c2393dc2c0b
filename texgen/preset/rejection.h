// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/assignment.h"

#include <initializer_list>
#include <span>
#include <string_view>

namespace foam::texgen {

/// Rejects an assignment: throws PresetError. The message is one line with the location, the key
/// and the value of the assignment, and the reason.
[[noreturn]] void reject(const Assignment& assignment, std::string_view reason);

/// Rejects the last assignment to any of the keys. The preset was valid before the assignments, so
/// an assignment to one of these keys is the probable cause of the error. If none of the keys is
/// assigned, rejects the last of all assignments. Precondition: there is at least one assignment.
[[noreturn]] void reject_last(std::span<const Assignment> assignments,
                              std::initializer_list<std::string_view> keys,
                              std::string_view reason);

/// Rejects an assignment with a value that `key` does not allow. The reason describes the allowed
/// values. If the value contains a misspelled word, the reason also suggests the nearest word that
/// is allowed. If no word is suggested, the reason also contains the text that KeyInfo::fault
/// returns for the value.
[[noreturn]] void reject_value(const Assignment& assignment, const KeyInfo& key);

/// Rejects an assignment to an unknown key or table. `meant` is the name that was probably meant,
/// or empty if no known name is similar.
[[noreturn]] void reject_unknown(const Assignment& assignment, std::string_view meant);

}  // namespace foam::texgen
