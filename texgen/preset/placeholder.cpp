// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/placeholder.h"

#include "texgen/keys/nearest.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::array<std::string_view, 4> kShortWords = {"{preset}", "{map}", "{seed}", "{size}"};
constexpr std::string_view kPatternKey = "output.pattern";
constexpr std::string_view kSheetPatternKey = "output.sheet_pattern";

// The largest number of bytes of a text in a file name. Most file systems allow 255 bytes for the
// whole name.
constexpr std::size_t kMaxTextBytes = 64;

[[noreturn]] void reject(std::string_view name, std::string_view reason) {
    throw std::invalid_argument(fmt::format("placeholder {{{}}}: {}", name, reason));
}

[[noreturn]] void reject_unknown(std::string_view name) {
    const std::string word = fmt::format("{{{}}}", name);
    const std::string_view key = nearest_key(name);
    std::string meant(nearest(word, kShortWords));
    if (meant.empty() && !key.empty()) {
        meant = fmt::format("{{{}}}", key);
    }
    throw std::invalid_argument(fmt::format(
        "unknown placeholder '{}'; {}",
        word,
        meant.empty() ? "must be {preset}, {map}, {seed}, {size} or a key such as {foam.bubbles}"
                      : fmt::format("did you mean {}?", meant)));
}

std::string size_text(const ImageOptions& image) {
    return image.width == image.height ? fmt::format("{}", image.width)
                                       : fmt::format("{}x{}", image.width, image.height);
}

// Returns the part of a file name for a text that is the value of a key.
std::string part_of(std::string_view name, const std::string& text) {
    std::string part = file_name_part(text);
    if (part.empty()) {
        reject(name, fmt::format("the value '{}' has no letter and no digit", text));
    }
    if (part.size() > kMaxTextBytes) {
        reject(name,
               fmt::format("the value has {} bytes; a file name may contain a text of at most {}",
                           part.size(),
                           kMaxTextBytes));
    }
    return part;
}

// Returns true if the value of a key is "auto" and stands for a number that the bake finds.
bool is_automatic_number(const KeyInfo& key, const Value& value) {
    const auto* const text = std::get_if<std::string>(&value.data);
    return text != nullptr && *text == "auto" &&
           std::ranges::find(key.words, *text) == key.words.end();
}

std::string value_text(std::string_view name, const KeyInfo& key, const Value& value) {
    if (is_automatic_number(key, value)) {
        reject(name, "the value is \"auto\", a number that only the bake finds; set a number");
    }
    if (const auto* const integer = std::get_if<std::int64_t>(&value.data)) {
        return fmt::format("{}", *integer);
    }
    if (const auto* const real = std::get_if<double>(&value.data)) {
        return fmt::format("{}", *real);
    }
    if (const auto* const flag = std::get_if<bool>(&value.data)) {
        return *flag ? "true" : "false";
    }
    if (const auto* const text = std::get_if<std::string>(&value.data)) {
        return part_of(name, *text);
    }
    reject(name,
           key.path == "image.size" ? "the value is a list; did you mean {size}?"
                                    : "the value is a list, which is no part of a file name");
}

bool is_alphanumeric(unsigned char c) {
    constexpr unsigned char kLastAscii = 0x7F;
    return c > kLastAscii || std::isalnum(c) != 0;
}

}  // namespace

std::string placeholder_text(const Preset& preset, std::string_view name) {
    if (name == "preset") {
        return preset.name;
    }
    if (name == "size") {
        return size_text(preset.image);
    }
    const std::string_view path = name == "seed" ? "foam.seed" : name;
    const Key<Preset>* const key = find_key(path);
    if (key == nullptr) {
        reject_unknown(name);
    }
    if (path == kPatternKey || path == kSheetPatternKey) {
        reject(name, "a file name cannot contain a pattern of file names");
    }
    const std::optional<Value> value = key->write(preset);
    if (!value) {
        reject(name, "the key has no value");
    }
    return value_text(name, *key, *value);
}

std::string with_placeholders_filled(const Preset& preset, std::string_view text) {
    constexpr std::string_view kMap = "{map}";
    std::string filled;
    while (!text.empty()) {
        const std::size_t open = std::min(text.find('{'), text.size());
        filled += text.substr(0, open);
        text.remove_prefix(open);
        if (text.empty()) {
            break;
        }
        const std::size_t close = text.find('}');
        if (close == std::string_view::npos) {
            throw std::invalid_argument(fmt::format("'{}' has no closing brace", text));
        }
        const std::string_view word = text.substr(0, close + 1);
        filled += word == kMap ? std::string(word)
                               : placeholder_text(preset, word.substr(1, word.size() - 2));
        text.remove_prefix(word.size());
    }
    return filled;
}

std::string file_name_part(std::string_view text) {
    std::string part;
    bool is_pending = false;  // true if characters have been skipped since the last one in `part`
    for (const char c : text) {
        if (is_alphanumeric(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '-') {
            part += is_pending ? "-" : "";
            part += c;
            is_pending = false;
        } else {
            is_pending = true;
        }
    }
    constexpr std::string_view kMarks = "._-";
    const std::size_t first = part.find_first_not_of(kMarks);
    const std::size_t last = part.find_last_not_of(kMarks);
    return first == std::string::npos ? "" : part.substr(first, last - first + 1);
}

}  // namespace foam::texgen
