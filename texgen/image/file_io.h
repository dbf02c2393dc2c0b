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

/// The whole content of a file. Throws InputError.
Bytes read_file(const std::filesystem::path& path);

/// Writes all or nothing: under a temporary name in the same folder, renamed to `path` once every
/// byte and the close are known to be good, so that nobody ever sees half a file. An older file of
/// the name is replaced. The folder has to exist. Throws OutputError, after removing the temporary.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content);

/// Makes the folder and those it lies in, as far as they are missing; an empty path is where the
/// program runs. Throws OutputError.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam::texgen
