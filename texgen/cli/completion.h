// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/grammar.h"

#include <map>
#include <string>
#include <vector>

namespace foam::texgen {

/// The words that completion offers as values.
struct CompletionWords {
    std::vector<std::string> presets;
    std::vector<std::string> maps;
    std::vector<std::string> keys;  // keys of presets, such as "foam.seed"
    // The words that are values of a key, such as "viridis" for "albedo.colormap".
    std::map<std::string, std::vector<std::string>> values_of_keys{};
};

/// Return a script that completes the command lines of a program, for bash and for zsh. The script
/// offers the names of maps after --maps. After --set it offers keys and, after the '=', the values
/// of the key that are words. For the positional argument PRESET it offers preset names and files;
/// bash offers files only if no preset name matches. For the positional argument NAME it offers
/// only preset names. For an option with a placeholder such as "a|b|c", it offers the words a, b
/// and c. For all other values, it offers files.
std::string bash_completion(const CommandGrammar& program, const CompletionWords& words);
std::string zsh_completion(const CommandGrammar& program, const CompletionWords& words);

}  // namespace foam::texgen
