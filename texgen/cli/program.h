// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

namespace foam::texgen {

/// Runs the program foamtex with the arguments of main() and returns the exit code. Reports every
/// error as one line on stderr. Throws nothing.
ExitCode run_program(int argc, char** argv);

/// Does the same as run_program, but without the preparations that a process makes only once, so
/// that a command can run further command lines. The first argument is the name of the program, as
/// in main(), and is ignored.
ExitCode run_command_line(int argc, char** argv);

}  // namespace foam::texgen
