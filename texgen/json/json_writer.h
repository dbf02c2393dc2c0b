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

/// Returns a JSON value as text on one line. In strings that are not UTF-8, such as some file
/// names, the invalid bytes are replaced by the character U+FFFD.
std::string json_text(const Json& value);

/// Returns a JSON value as the text of a file: indented by two spaces per level, with a newline at
/// the end. Invalid bytes are replaced as in json_text.
std::string indented(const Json& value);

}  // namespace foam::texgen
