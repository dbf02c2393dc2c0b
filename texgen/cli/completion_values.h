// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/completion.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The kind of value that an argument has, for completion.
enum class ValueKind {
    Words,  // one of the words
    List,   // several of the words, separated by commas
    Key,    // one of the words, followed by '=' and any value
    Path,   // the path of a file
};

/// The values that completion offers for an argument.
struct Values {
    ValueKind kind = ValueKind::Path;
    std::vector<std::string> words{};
};

/// Returns the values that completion offers for an argument.
Values values_of(const ArgumentGrammar& argument, const CompletionWords& words);

/// Joins words with blanks between them.
std::string joined(const std::vector<std::string>& words);

}  // namespace foam::texgen
