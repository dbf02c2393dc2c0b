#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A value of a JSON file that knows where it stands. Reading another kind of value than there is
/// throws an InputError that names the file, the place, the value, and what is allowed.
class JsonValue {
  public:
    /// The whole of a file, borrowed.
    JsonValue(const nlohmann::json& json, std::string file);

    /// A member of an object; throws where there is none.
    JsonValue operator[](std::string_view name) const;
    /// Nothing where there is none, or it is null.
    std::optional<JsonValue> find(std::string_view name) const;
    /// Of a list.
    std::vector<JsonValue> items() const;

    const std::string& text() const;
    /// One of these.
    const std::string& word(std::span<const std::string_view> words) const;
    std::int64_t integer(std::int64_t low, std::int64_t high) const;
    int count() const;  // an integer from 0 on
    double number() const;
    bool flag() const;

    /// Throws: the value "must be" this.
    [[noreturn]] void refuse(std::string_view must_be) const;

  private:
    JsonValue(const nlohmann::json* json, std::string file, std::string place);

    const nlohmann::json* json_;
    std::string file_;
    std::string place_;
};

}  // namespace foam::texgen
