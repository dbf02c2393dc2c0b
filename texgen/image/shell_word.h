// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace foam::texgen {

/// Returns a word in the notation of a POSIX shell: unchanged if it consists of ASCII letters,
/// digits and a few harmless characters such as '-' and '/', otherwise in single quotes.
std::string shell_word(const std::string& word);

}  // namespace foam::texgen
