// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace foam::texgen {

/// A JSON value to be written. Members of an object keep the order in which they are added.
using Json = nlohmann::ordered_json;

/// Returns a number as JSON, or null if the number is missing or not finite. JSON cannot represent
/// infinities and NaN.
Json number_or_null(const std::optional<double>& number);

/// Returns a JSON array of paths, as strings.
Json path_list(std::span<const std::filesystem::path> paths);

/// Returns a JSON value as text on one line. Texts in it that are not UTF-8, such as some file
/// names, get the character U+FFFD for each byte that is not.
std::string json_text(const Json& value);

/// Returns a JSON value as the text of a file: indented by two spaces, with a newline at the end.
std::string indented(const Json& value);

}  // namespace foam::texgen
