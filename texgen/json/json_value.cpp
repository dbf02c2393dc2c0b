// SPDX-License-Identifier: Apache-2.0

#include "texgen/json/json_value.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "core/files/shown_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace foam::texgen {

namespace {

// The largest allowed number of arrays and objects around a value. Manifests need only 9, for the
// bubbles of an event in "measurements". Functions of nlohmann-json are recursive and use stack
// memory in proportion to this number.
constexpr int kMaxDepth = 16;

/// Returns the parser's message without its error code. If the message quotes the text that was
/// read last, the part from this text on is made printable. This part is also shortened in the
/// middle to kMaxQuoteLength characters.
std::string reason(const std::string& what) {
    constexpr std::string_view kQuote = "last read: '";
    const std::size_t code = what.find("] ");
    std::string message = code == std::string::npos ? what : what.substr(code + 2);
    if (const std::size_t quote = message.find(kQuote); quote != std::string::npos) {
        const std::size_t begin = quote + kQuote.size();
        message = message.substr(0, begin) + shown_text(message.substr(begin), kMaxQuoteLength);
    }
    return message;
}

}  // namespace

JsonValue::JsonValue(const nlohmann::json* json, std::string file, std::string path)
    : json_(json), file_(std::move(file)), path_(std::move(path)) {}

JsonValue JsonValue::operator[](std::string_view name) const {
    const auto found = find(name);
    if (!found) {
        reject(fmt::format("an object with the key '{}'", name));
    }
    return *found;
}

std::optional<JsonValue> JsonValue::find(std::string_view name) const {
    if (!json_->is_object()) {
        reject("an object");
    }
    const auto found = json_->find(name);
    if (found == json_->end() || found->is_null()) {
        return std::nullopt;
    }
    return JsonValue(&*found, file_, fmt::format("{}{}{}", path_, path_.empty() ? "" : ".", name));
}

std::vector<JsonValue> JsonValue::items() const {
    if (!json_->is_array()) {
        reject("an array");
    }
    std::vector<JsonValue> items;
    for (const nlohmann::json& item : *json_) {
        items.push_back(JsonValue(&item, file_, fmt::format("{}[{}]", path_, items.size())));
    }
    return items;
}

const std::string& JsonValue::text() const {
    if (!json_->is_string()) {
        reject("a string");
    }
    return json_->get_ref<const std::string&>();
}

const std::string& JsonValue::word(std::span<const std::string_view> words) const {
    const std::string& found = text();
    if (std::ranges::find(words, found) == words.end()) {
        std::string allowed;
        for (const std::string_view allowed_word : words) {
            allowed += fmt::format("{}\"{}\"", allowed.empty() ? "one of " : ", ", allowed_word);
        }
        reject(allowed);
    }
    return found;
}

std::int64_t JsonValue::integer(std::int64_t low, std::int64_t high) const {
    const bool fits =
        json_->is_number_integer() &&
        !(json_->is_number_unsigned() &&
          json_->get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()});
    const std::int64_t found = fits ? json_->get<std::int64_t>() : 0;
    if (!fits || found < low || found > high) {
        reject(fmt::format("an integer from {} to {}", low, high));
    }
    return found;
}

int JsonValue::count() const {
    return static_cast<int>(integer(0, std::numeric_limits<int>::max()));
}

double JsonValue::number() const {
    if (!json_->is_number()) {
        reject("a number");
    }
    return json_->get<double>();
}

bool JsonValue::flag() const {
    if (!json_->is_boolean()) {
        reject("true or false");
    }
    return json_->get<bool>();
}

std::string JsonValue::object_text() const {
    if (!json_->is_object()) {
        reject("an object");
    }
    return json_->dump();
}

const std::string& JsonValue::name() const {
    if (!is_plain_name(text())) {
        reject("a plain name, without '/' and control characters and not beginning with '.'");
    }
    return text();
}

void JsonValue::reject(std::string_view must_be) const {
    throw InputError(fmt::format("cannot read '{}': {}{}{}: must be {}",
                                 file_,
                                 path_,
                                 path_.empty() ? "" : " = ",
                                 cut_text(json_->dump()),
                                 must_be));
}

JsonDocument::JsonDocument(std::string_view text, std::string file) : file_(std::move(file)) {
    if (text.empty()) {
        throw InputError(fmt::format("cannot read '{}': the file is empty; remove it", file_));
    }
    try {
        const auto check_depth = [this](int depth, nlohmann::json::parse_event_t, const auto&) {
            if (depth > kMaxDepth) {
                throw InputError(fmt::format(
                    "cannot read '{}': nested more than {} levels deep", file_, kMaxDepth));
            }
            return true;
        };
        tree_ = std::make_unique<nlohmann::json>(nlohmann::json::parse(text, check_depth));
    } catch (const nlohmann::json::exception& error) {
        fail_to_read(file_, reason(error.what()));
    }
}

JsonDocument::~JsonDocument() = default;

JsonDocument JsonDocument::read(const std::filesystem::path& path) {
    const Bytes bytes = read_file(path, kDescriptionInput);
    return {as_text(bytes), path.string()};
}

JsonValue JsonDocument::root() const {
    return {tree_.get(), file_, ""};
}

void JsonDocument::check_format(std::string_view what, std::string_view format, int version) const {
    if (!tree_->is_object() || !tree_->contains("format") || (*tree_)["format"] != format) {
        root().reject(fmt::format("{}, with \"format\": \"{}\"", what, format));
    }
    root()["version"].integer(1, version);
}

}  // namespace foam::texgen
