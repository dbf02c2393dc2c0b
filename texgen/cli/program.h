// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

namespace foam::texgen {

/// Runs the program foamtex with the arguments of main(). Every error ends as one line on stderr
/// and an exit code; nothing is thrown.
ExitCode run_program(int argc, char** argv);

}  // namespace foam::texgen
