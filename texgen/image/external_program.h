// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The folder in which an external program runs, and whether its errors are shown.
struct ExternalOptions {
    std::filesystem::path folder = {};  // its working directory; empty: the one of this process
    bool shows_errors = true;           // forwards its standard error to the one of this process
};

/// Runs a program without a shell, so that no character of an argument has a special meaning, and
/// waits until it ends. The first argument is the name of the program, which is searched in PATH.
/// Standard input is empty and standard output is discarded. Returns the exit code, -1 if a signal
/// ended the program, or nullopt if the program is not installed. Throws OutputError if the program
/// cannot be started for another reason.
std::optional<int> run_external(std::vector<std::string> arguments,
                                const ExternalOptions& options = {});

}  // namespace foam::texgen
