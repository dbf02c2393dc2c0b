// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns a word in the notation of a POSIX shell: in quotes if it is empty or contains characters
/// that may have a meaning in a shell.
std::string shell_word(const std::string& word);

}  // namespace foam::texgen
