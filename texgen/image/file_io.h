// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

/// An input file that is unreadable or malformed; the message names file and reason.
class InputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// An output file that could not be written; the message names file and reason.
class OutputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

using Bytes = std::vector<std::byte>;

/// Returns the whole content of a file. Throws InputError if it cannot be read.
Bytes read_file(const std::filesystem::path& path);

/// Writes a file atomically: writes a temporary file in the same folder, closes it, and renames it
/// to `path` if all of this succeeded, so no reader sees a partial file. Replaces an existing file.
/// Precondition: the folder exists. Throws OutputError, after removing the temporary file, if
/// writing fails.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content);

/// Creates the folder and its parents where they do not exist. An empty path, which is the working
/// directory, needs nothing. Throws OutputError if a folder cannot be created.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam::texgen
