// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// An option or a positional argument of a command.
struct ArgumentGrammar {
    std::vector<std::string> names;  // such as "-o" and "--out"; one name for a positional argument
    // Placeholder of the value ("W[xH]"); empty for flags and for positional arguments.
    std::string value;
    std::string meaning;
    bool repeats = false;  // true for an option that may be given several times
};

/// The syntax of a command. The manual page and the completions are generated from it.
struct CommandGrammar {
    std::string name;
    std::string meaning;
    std::vector<ArgumentGrammar> positionals;
    std::vector<ArgumentGrammar> options;
    std::vector<CommandGrammar> commands;
    std::string notes;  // the footer of the help, such as examples
};

/// Returns the syntax of a command and of its subcommands.
CommandGrammar grammar_of(const CLI::App& app);

}  // namespace foam::texgen
