#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A value of a JSON file that knows its position in the file. Reading a value as another kind than
/// it is throws an InputError that names the file, the position, the value, and what is allowed.
class JsonValue {
  public:
    /// Returns a member of an object; throws if there is none.
    JsonValue operator[](std::string_view name) const;
    /// Returns a member of an object, or nothing if it is missing or null.
    std::optional<JsonValue> find(std::string_view name) const;
    /// Returns the items of a list.
    std::vector<JsonValue> items() const;

    const std::string& text() const;
    /// Returns a text that is one of these words.
    const std::string& word(std::span<const std::string_view> words) const;
    std::int64_t integer(std::int64_t low, std::int64_t high) const;
    int count() const;  // an integer of 0 or more
    double number() const;
    bool flag() const;

    /// Returns parse(text()). If that throws std::invalid_argument, the text "must be" as told.
    template <class Parse>
    auto parsed(const Parse& parse, std::string_view must_be) const {
        try {
            return parse(text());
        } catch (const std::invalid_argument&) {
            refuse(must_be);
        }
    }

    /// Throws: the value "must be" this.
    [[noreturn]] void refuse(std::string_view must_be) const;

  private:
    friend class JsonDocument;
    JsonValue(const nlohmann::json* json, std::string file, std::string place);

    const nlohmann::json* json_;
    std::string file_;
    std::string place_;
};

/// The content of a JSON file.
class JsonDocument {
  public:
    /// Throws InputError, in the name of the file, if the text is no JSON.
    JsonDocument(std::string_view text, std::string file);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    /// Reads a file. Throws InputError.
    static JsonDocument read(const std::filesystem::path& path);

    /// Returns the whole content; it borrows the document.
    JsonValue root() const;

    /// Checks the members "format" and "version" of the root. Throws InputError for another format
    /// than this, which is called `what` ("a manifest"), and for a newer version.
    void check_format(std::string_view what, std::string_view format, int version) const;

  private:
    std::string file_;
    std::unique_ptr<nlohmann::json> tree_;
};

}  // namespace foam::texgen
