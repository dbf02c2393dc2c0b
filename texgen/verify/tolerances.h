// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/difference_limits.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace foam::texgen {

/// The limits of the differences between images, with a table of limits for each map.
class Tolerances {
  public:
    /// The limits of all maps are the defaults of CompareLimits.
    Tolerances() = default;

    /// Constructs tolerances from tables of limits. The key of each table is the name of a map, or
    /// "default".
    explicit Tolerances(std::map<std::string, CompareLimits, std::less<>> tables)
        : tables_(std::move(tables)) {}

    /// Returns the limits in the table of a map. If the map has no table, returns the limits in the
    /// table "default". If this table does not exist either, returns the defaults of CompareLimits.
    /// `map` is empty if the map is not known.
    CompareLimits limits_of(std::string_view map) const;

  private:
    std::map<std::string, CompareLimits, std::less<>> tables_;
};

/// Parses a TOML document. Each of its tables has the name of a map or is [default]; none of them
/// is required. The keys of a table are those of the list limit_keys (limit_keys.h). If a table has
/// no key for warnings (is_warning_key), differences never exceed its limits for warnings. Throws
/// PresetError (preset/assignment.h) if the document is invalid; the message is one line. `source`
/// is the name of the document for messages.
Tolerances parse_tolerances(std::string_view toml, const std::string& source);

/// Reads a file of tolerances. Throws PresetError if it is unreadable or invalid.
Tolerances read_tolerances(const std::filesystem::path& path);

}  // namespace foam::texgen
