#pragma once

#include "texgen/cli/grammar.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Words that values are chosen from.
struct CompletionWords {
    std::vector<std::string> presets;
    std::vector<std::string> maps;
    std::vector<std::string> keys;  // of presets
};

/// A script that completes command lines of a program, in bash and in zsh. After PRESET come names
/// of presets and files, after a list of words with '|' these, and elsewhere files.
std::string bash_completion(const CommandGrammar& program, const CompletionWords& words);
std::string zsh_completion(const CommandGrammar& program, const CompletionWords& words);

}  // namespace foam::texgen
