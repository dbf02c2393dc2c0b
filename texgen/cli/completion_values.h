#pragma once

#include "texgen/cli/completion.h"

#include <string>
#include <vector>

namespace foam::texgen {

enum class ValueKind {
    Words,  // one of some
    List,   // several of some, with commas
    Key,    // one of some, to be gone on from with '='
    Path,   // of a file
};

/// What may stand for an argument.
struct Values {
    ValueKind kind = ValueKind::Path;
    std::vector<std::string> words{};
};

Values values_of(const ArgumentGrammar& argument, const CompletionWords& words);

/// With blanks between them.
std::string joined(const std::vector<std::string>& words);

}  // namespace foam::texgen
