// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/completion.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The kind of values that completion offers for an argument.
enum class ValueKind {
    Words,  // one of Values::words
    List,   // several of Values::words, separated by commas
    Key,    // one of Values::words, followed by '=' and any value
    Path,   // the path of a file or folder; also used for values for which there are no words
};

/// The values that completion offers for an argument.
struct Values {
    ValueKind kind = ValueKind::Path;
    std::vector<std::string> words{};  // empty for paths
};

/// Returns the values that completion offers for an argument. For the positional argument PRESET,
/// the completion scripts also offer files, although the kind of the result is Words.
Values values_of(const ArgumentGrammar& argument, const CompletionWords& words);

/// Returns the words, separated by spaces.
std::string joined(const std::vector<std::string>& words);

}  // namespace foam::texgen
