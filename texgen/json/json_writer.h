#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace foam::texgen {

/// A JSON value that is written. Members keep the order in which they are added.
using Json = nlohmann::ordered_json;

/// Returns null for a missing number and for one that is not finite, for which JSON has no word.
Json number_or_null(const std::optional<double>& number);

/// Returns a list of paths.
Json path_list(std::span<const std::filesystem::path> paths);

/// Returns the text of a file: indented, with an end of line.
std::string indented(const Json& value);

}  // namespace foam::texgen
