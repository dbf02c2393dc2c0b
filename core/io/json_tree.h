// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam {

/// A JSON value with the line on which it begins.
struct JsonTree {
    using Array = std::vector<JsonTree>;
    using Object = std::vector<std::pair<std::string, JsonTree>>;  // in the order of the file

    std::variant<std::nullptr_t, bool, double, std::string, Array, Object> data = nullptr;
    int line = 1;

    /// Returns the member of an object, or nullptr if there is none or this is not an object.
    const JsonTree* find(std::string_view key) const;
};

/// Parses a JSON text. Throws FormatError if the text is not JSON, if it is nested deeper than 16
/// levels, or if an object has the same key twice. `file` is the name in the error message.
JsonTree parse_json(std::string_view text, const std::string& file);

}  // namespace foam
