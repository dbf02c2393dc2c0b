// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

/// Reports input that is unreadable or malformed. The message gives the reason. It also names the
/// file if the function that throws has its path.
class InputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports output that could not be produced, for example a file that cannot be written or a
/// program that cannot be started. The message gives the reason. It also names the file, if there
/// is one and the function that throws has its path.
class OutputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

using Bytes = std::vector<std::byte>;

/// Returns the whole content of a file. Throws InputError if the file cannot be read.
Bytes read_file(const std::filesystem::path& path);

/// Writes a file atomically, so that no reader sees a partial file: writes a temporary file in the
/// same folder, closes it and renames it to `path`. Replaces an existing file. Precondition: the
/// folder exists. If writing fails, removes the temporary file and throws OutputError.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content);

/// Throws OutputError if files cannot be written into a folder, or if the folder does not exist and
/// cannot be created. Creates nothing, so that a long computation can check its output first. An
/// empty path means the working directory.
void check_writable(const std::filesystem::path& folder);

/// Creates a folder and its parent folders if they do not exist. Does nothing for an empty path,
/// which means the working directory. Throws OutputError if a folder cannot be created.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam::texgen
