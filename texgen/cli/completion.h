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
    std::vector<std::string> tables{};    // tables of presets, such as "foam"
    std::vector<std::string> profiles{};  // shipped profiles of engines, such as "unreal"
};

/// Return a script that completes the command lines of a program, for bash and for zsh. The script
/// offers:
///
/// - the names of profiles after --for, and for the positional argument PROFILE;
/// - the names of maps after --map and --maps, and for the positional argument MAP;
/// - the formats of scene files after --scene;
/// - keys after --set and --sweep and, after the '=', those values of the key that are words;
/// - preset names and files for the positional argument PRESET (in bash, files only if no preset
///   name matches);
/// - preset names after --preset and for the positional argument NAME, and tables for TABLE;
/// - the words a, b and c for an option with a placeholder such as "a|b|c";
/// - files for all other values.
std::string bash_completion(const CommandGrammar& program, const CompletionWords& words);
std::string zsh_completion(const CommandGrammar& program, const CompletionWords& words);

}  // namespace foam::texgen
