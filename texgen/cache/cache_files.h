#pragma once

// The files of a cache; used by what writes and what reads it.

#include "texgen/cache/cache.h"

#include <filesystem>
#include <string>

namespace foam::texgen {

inline constexpr const char* kCacheName = "cache.json";

std::filesystem::path state_path(const std::filesystem::path& folder, int number);
std::filesystem::path pressures_path(const std::filesystem::path& folder);

/// Throws OutputError.
void write_info(const CacheInfo& info, const std::filesystem::path& folder);

/// Throws InputError.
CacheInfo read_info(const std::filesystem::path& folder);

}  // namespace foam::texgen
