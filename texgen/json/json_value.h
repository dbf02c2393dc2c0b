// SPDX-License-Identifier: Apache-2.0

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

/// A value of a JSON file, and its path in the file, such as "sets[0].size". A JsonValue refers to
/// its JsonDocument, which must outlive it. Every function throws InputError (core/files/file_io.h)
/// if the value has another JSON type than the function needs. The message names the file, the
/// path, the value, and the allowed values.
class JsonValue {
  public:
    /// Returns a member of an object. Throws InputError if it is missing or null.
    JsonValue operator[](std::string_view name) const;
    /// Returns a member of an object, or nullopt if it is missing or null.
    std::optional<JsonValue> find(std::string_view name) const;
    /// Returns the items of an array.
    std::vector<JsonValue> items() const;

    /// Returns a string.
    const std::string& text() const;
    /// Returns a string. Throws InputError unless it is one of `words`.
    const std::string& word(std::span<const std::string_view> words) const;
    /// Returns an integer. Throws InputError unless it is from `low` to `high`.
    std::int64_t integer(std::int64_t low, std::int64_t high) const;
    /// Returns an integer. Throws InputError if it is negative or does not fit an int.
    int count() const;
    /// Returns a number.
    double number() const;
    /// Returns true or false.
    bool flag() const;
    /// Returns an object as JSON on one line, with its members in alphabetical order.
    std::string object_text() const;

    /// Returns parse(text()). If `parse` throws std::invalid_argument, throws InputError; its
    /// message ends with "must be " + must_be.
    template <class Parse>
    auto parsed(const Parse& parse, std::string_view must_be) const {
        try {
            return parse(text());
        } catch (const std::invalid_argument&) {
            reject(must_be);
        }
    }

    /// Returns a string that is safe as a part of a file name. Throws InputError if it is not safe
    /// (is_plain_name): a JSON file may come from an untrusted source.
    const std::string& name() const;

    /// Throws InputError. Its message gives the file, the path and the value, and ends with
    /// "must be " + must_be.
    [[noreturn]] void reject(std::string_view must_be) const;

  private:
    friend class JsonDocument;
    JsonValue(const nlohmann::json* json, std::string file, std::string path);

    const nlohmann::json* json_;
    std::string file_;
    std::string path_;
};

/// The content of a JSON file.
class JsonDocument {
  public:
    /// Parses the content of a file. `file` is its name for error messages. Throws InputError if
    /// the content is not valid JSON, or is nested more than 16 levels deep.
    JsonDocument(std::string_view text, std::string file);
    ~JsonDocument();
    JsonDocument(const JsonDocument&) = delete;
    JsonDocument& operator=(const JsonDocument&) = delete;

    /// Reads and parses a file of at most kDescriptionInput.max_bytes. Throws InputError if the
    /// file cannot be read or is larger, and as the constructor does.
    static JsonDocument read(const std::filesystem::path& path);

    /// Returns the root value, which refers to this document.
    JsonValue root() const;

    /// Checks the members "format" and "version" of the root. Throws InputError unless the format
    /// is `format` and the version is from 1 to `version`. `what` describes the format in messages,
    /// for example "a manifest".
    void check_format(std::string_view what, std::string_view format, int version) const;

  private:
    std::string file_;
    std::unique_ptr<nlohmann::json> tree_;
};

}  // namespace foam::texgen
