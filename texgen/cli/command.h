#pragma once

#include "texgen/cli/exit_code.h"

#include <functional>
#include <span>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The action that the command line asked for, ready to run. Failures leave as exceptions.
using Action = std::function<ExitCode()>;

/// Adds one command to the program. Parsing a command line that names the command sets `action`.
using AddCommand = void (*)(CLI::App& app, Action& action);

/// All commands, in the order of the help. CMakeLists.txt has the list; the command `name` is the
/// function `add_name_command` of the file name_command.cpp.
std::span<const AddCommand> all_commands();

}  // namespace foam::texgen
