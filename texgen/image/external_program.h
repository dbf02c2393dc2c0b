// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// Options of run_external.
struct ExternalOptions {
    /// The working directory of the program. If the path is empty, the program runs in the working
    /// directory of this process.
    std::filesystem::path folder = {};
    /// If true, the program writes to the standard error of this process. If false, its standard
    /// error is discarded.
    bool shows_errors = true;
    /// If not empty, the program writes its standard error to this file, whatever `shows_errors`
    /// is. The file is created, or truncated if it exists. A relative path refers to the working
    /// directory of this process.
    std::filesystem::path error_file = {};
};

/// Runs a program and waits until it ends. `arguments` must not be empty. Its first element is the
/// name of the program, which is looked up in PATH unless it contains a '/'. No shell is used, so
/// no character of an argument has a special meaning. Standard input is empty and standard output
/// is discarded. Returns the exit code, -1 if a signal ended the program, or nullopt if the program
/// or the folder of `options.error_file` does not exist. Throws OutputError if the working
/// directory does not exist, or if the program cannot be started for another reason.
std::optional<int> run_external(std::vector<std::string> arguments,
                                const ExternalOptions& options = {});

}  // namespace foam::texgen
