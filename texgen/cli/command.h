// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

#include <functional>
#include <span>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The action of the command that was parsed. Running it returns an exit code or throws.
using Action = std::function<ExitCode()>;

/// Adds one command to the program. If a command line names this command, parsing the command line
/// sets `action`.
using AddCommand = void (*)(CLI::App& app, Action& action);

/// Returns the functions that add the commands, in the order of the help. CMake generates this list
/// from the names in CMakeLists.txt: the command `name` is added by the function `add_name_command`
/// in name_command.cpp.
std::span<const AddCommand> all_commands();

}  // namespace foam::texgen
