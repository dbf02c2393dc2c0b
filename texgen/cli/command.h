// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

#include <functional>
#include <span>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The action of the parsed command, ready to run. It returns an exit code or throws.
using Action = std::function<ExitCode()>;

/// Adds one command to the program. Parsing a command line that names the command sets `action`.
using AddCommand = void (*)(CLI::App& app, Action& action);

/// Returns the functions that add the commands, in the order of the help. The list is in
/// CMakeLists.txt. The command `name` is added by `add_name_command` in name_command.cpp.
std::span<const AddCommand> all_commands();

}  // namespace foam::texgen
