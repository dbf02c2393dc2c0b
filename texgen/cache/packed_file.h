// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace foam::texgen {

/// The version of the format of packed files. A packed file is a compressed file of a cache, with a
/// label and a checksum. Files of another version are rejected.
inline constexpr std::uint32_t kPackedVersion = 2;

/// The label of a packed file. A file is rejected unless both members have the expected values.
struct PackedLabel {
    std::string_view kind;             // kind of content, such as "state"; at most 8 characters
    std::string_view simulation_hash;  // hash of the simulation, 32 hexadecimal digits
};

/// Compresses content and writes it atomically to a file with a checksum. Precondition: the folder
/// exists. Throws OutputError if the file cannot be written.
void write_packed(const std::filesystem::path& path,
                  const PackedLabel& label,
                  std::span<const std::byte> content);

/// Returns the uncompressed content of a packed file. `file` contains the bytes of the whole file.
/// Throws BadContent (byte_stream.h) if the file is damaged or has another version or label.
Bytes unpack_file(std::span<const std::byte> file, const PackedLabel& label);

/// Reads a packed file and returns its uncompressed content. Throws InputError if the file is
/// missing or damaged, or has another version or label.
Bytes read_packed(const std::filesystem::path& path, const PackedLabel& label);

}  // namespace foam::texgen
