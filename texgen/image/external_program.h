// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// Options of run_external.
struct ExternalOptions {
    std::filesystem::path folder = {};  // working directory; if empty, that of this process
    bool shows_errors = true;           // inherits standard error; if false, it is discarded
};

/// Runs a program and waits until it ends. No shell is used, so that no character of an argument
/// has a special meaning. The first argument is the name of the program, which is searched in PATH.
/// Standard input is empty and standard output is discarded. Returns the exit code, -1 if a signal
/// ended the program, or nullopt if the program is not installed. Throws OutputError if the program
/// cannot be started for another reason.
std::optional<int> run_external(std::vector<std::string> arguments,
                                const ExternalOptions& options = {});

}  // namespace foam::texgen
