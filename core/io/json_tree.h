#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam {

/// A JSON value that knows the line it begins on.
struct JsonTree {
    using Array = std::vector<JsonTree>;
    using Object = std::vector<std::pair<std::string, JsonTree>>;  // in the order of the file

    std::variant<std::nullptr_t, bool, double, std::string, Array, Object> data = nullptr;
    int line = 1;

    /// The member of an object, or nullptr where there is none or this is no object.
    const JsonTree* find(std::string_view key) const;
};

/// Throws FormatError, in the name of `file`, where the text is no JSON, nests deeper than a few
/// levels, or has a key twice in an object.
JsonTree parse_json(std::string_view text, const std::string& file);

}  // namespace foam
