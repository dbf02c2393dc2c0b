// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The name of the file that describes a cache.
inline constexpr const char* kCacheName = "cache.json";

/// The description of a cache.
struct CacheInfo {
    Preset preset;
    std::string version;                  // version of foamtex that simulated the states
    std::string simulation;               // result of simulation_hash
    std::vector<int> frames;              // frames that can be drawn once the simulation has ended
    std::optional<double> closing_error;  // Simulation::closing_error
};

/// Returns true if the path is a folder that contains the description of a cache.
bool is_cache(const std::filesystem::path& path);

/// Returns the path of the file that contains the state with the given number.
std::filesystem::path state_path(const std::filesystem::path& folder, int number);

/// Returns the path of the file that contains the pressures at the end of the warm-up
/// (FoamRecord::first_pressures).
std::filesystem::path pressures_path(const std::filesystem::path& folder);

/// Writes the description of a cache. Throws OutputError if the file cannot be written.
void write_info(const CacheInfo& info, const std::filesystem::path& folder);

/// Parses the description of a cache. `file` is the name of the file for error messages. Throws
/// InputError if the text is not a description of a cache, or if the version of its file format is
/// newer than this program supports.
CacheInfo parse_info(std::string_view text, const std::string& file);

/// Reads the description of a cache. Throws InputError if the file is missing or unreadable, and
/// for the same reasons as parse_info.
CacheInfo read_info(const std::filesystem::path& folder);

}  // namespace foam::texgen
