// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace foam::texgen {

/// A JSON value to be written. Members keep the order in which they are added.
using Json = nlohmann::ordered_json;

/// Returns a number, or null if it is missing or not finite. JSON cannot represent infinities and
/// NaN.
Json number_or_null(const std::optional<double>& number);

/// Returns an array of paths.
Json path_list(std::span<const std::filesystem::path> paths);

/// Returns the text of a JSON file: indented by two spaces, with a newline at the end.
std::string indented(const Json& value);

}  // namespace foam::texgen
