// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

#include <string>

namespace foam::texgen {

/// Prints a message on stderr as one line. Returns the given exit code.
ExitCode report_failure(const std::string& message, ExitCode code);

/// Prints one line on stderr about the exception that is being handled, and returns its exit code.
/// The README of this folder lists the exit codes of exceptions. Precondition: the exception is
/// derived from std::exception.
ExitCode report_exception();

}  // namespace foam::texgen
