// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

/// Reports an input file that is unreadable or malformed. The message names the file and the
/// reason.
class InputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports an output file that could not be written. The message names the file and the reason.
class OutputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

using Bytes = std::vector<std::byte>;

/// Returns the whole content of a file. Throws InputError if it cannot be read.
Bytes read_file(const std::filesystem::path& path);

/// Writes a file atomically, so no reader sees a partial file: writes and closes a temporary file
/// in the same folder, then renames it to `path`. Replaces an existing file. Precondition: the
/// folder exists. Throws OutputError, after removing the temporary file, if writing fails.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content);

/// Creates the folder and its parents if they do not exist. Does nothing for an empty path, which
/// means the working directory. Throws OutputError if a folder cannot be created.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam::texgen
