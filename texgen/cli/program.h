// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

namespace foam::texgen {

/// Runs the program foamtex with the arguments of main() and returns the exit code. Reports every
/// error as one line on stderr. Throws nothing.
ExitCode run_program(int argc, char** argv);

/// Runs a command line within the program as run_program does, but without the preparations that a
/// process makes once. The first argument is ignored, as in main().
ExitCode run_command_line(int argc, char** argv);

}  // namespace foam::texgen
