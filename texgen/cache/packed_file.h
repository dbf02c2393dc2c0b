#pragma once

#include "texgen/image/file_io.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace foam::texgen {

/// Of the format of what stands in packed files; one of another version is refused.
inline constexpr std::uint32_t kPackedVersion = 1;

/// What a file is about: it is read only where both are the same.
struct PackedLabel {
    std::string_view kind;     // "state", at most 8 letters
    std::string_view belongs;  // 32 letters: the simulation that it comes from
};

/// Writes bytes compressed and with a check sum, all or nothing. Throws OutputError.
void write_packed(const std::filesystem::path& path,
                  const PackedLabel& label,
                  std::span<const std::byte> content);

/// Undoes write_packed. Throws InputError for a file that is missing, damaged, of another version,
/// or about something else.
Bytes read_packed(const std::filesystem::path& path, const PackedLabel& label);

}  // namespace foam::texgen
