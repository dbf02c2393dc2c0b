#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// An option of a command, or what it takes without one.
struct ArgumentGrammar {
    std::vector<std::string> names;  // "-o", "--out"; of what comes without an option its one name
    std::string value;               // what it takes, "W[xH]"; empty for a flag
    std::string meaning;
};

/// What a command takes, as manuals and completions tell it.
struct CommandGrammar {
    std::string name;
    std::string meaning;
    std::vector<ArgumentGrammar> positionals;
    std::vector<ArgumentGrammar> options;
    std::vector<CommandGrammar> commands;
    std::string notes;  // after all that: examples and what else help says
};

CommandGrammar grammar_of(const CLI::App& app);

}  // namespace foam::texgen
