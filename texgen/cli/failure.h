// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"

#include <string>

namespace foam::texgen {

/// Prints a message on stderr as one line. Returns the given exit code.
ExitCode report_failure(const std::string& message, ExitCode code);

/// Prints the exception that is being handled on stderr as one line, and returns its exit code, as
/// the README of this folder lists them. Precondition: the exception is derived from
/// std::exception.
ExitCode report_exception();

}  // namespace foam::texgen
