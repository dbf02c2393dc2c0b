// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/value_kinds.h"

#include "texgen/image/color.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foam::texgen {

namespace {

template <class T>
const T* get(const Value& value) {
    return std::get_if<T>(&value.data);
}

/// Returns the number of a value that is an integer or a real number, or nullopt for other values.
std::optional<double> real(const Value& value) {
    if (const auto* integer = get<std::int64_t>(value)) {
        return static_cast<double>(*integer);
    }
    const auto* real = get<double>(value);
    return real != nullptr ? std::optional(*real) : std::nullopt;
}

bool is_color(const std::string& text) {
    try {
        parse_color(text);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

bool contains(const auto& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Stores a string in the member if `allows` returns true for it. Returns true if it was stored.
bool read_text(const Value& value, std::string& member, const auto& allows) {
    const auto* text = get<std::string>(value);
    if (text == nullptr || !allows(*text)) {
        return false;
    }
    member = *text;
    return true;
}

/// Returns the words in quotes, separated by commas.
std::string quoted(std::span<const std::string_view> words) {
    std::string list;
    for (const std::string_view word : words) {
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", word);
    }
    return list;
}

Value list_of(const std::vector<std::string>& words) {
    Value::List list;
    for (const std::string& word : words) {
        list.push_back({word});
    }
    return {std::move(list)};
}

}  // namespace

std::string list_schema(const std::string& item, std::size_t min_items, std::size_t max_items) {
    std::string schema = fmt::format(R"({{"type": "array", "items": {})", item);
    if (min_items > 0) {
        schema += fmt::format(R"(, "minItems": {})", min_items);
    }
    if (max_items > 0) {
        schema += fmt::format(R"(, "maxItems": {})", max_items);
    }
    return schema + "}";
}

std::string any_of_schema(const std::string& one, const std::string& other) {
    return fmt::format(R"({{"anyOf": [{}, {}]}})", one, other);
}

std::string Integers::allowed() const {
    return fmt::format("an integer from {} to {}", low, high);
}

std::string Integers::schema() const {
    return fmt::format(R"({{"type": "integer", "minimum": {}, "maximum": {}}})", low, high);
}

std::optional<std::int64_t> Integers::accepted(const Value& value) const {
    const auto* integer = get<std::int64_t>(value);
    const bool inside = integer != nullptr && *integer >= low && *integer <= high;
    return inside ? std::optional(*integer) : std::nullopt;
}

std::string Reals::allowed() const {
    return fmt::format("{}a number from {} to {}", or_zero ? "0 or " : "", low, high);
}

std::string Reals::schema() const {
    const std::string range =
        fmt::format(R"({{"type": "number", "minimum": {}, "maximum": {}}})", low, high);
    return or_zero ? any_of_schema(R"({"const": 0})", range) : range;
}

bool Reals::read(const Value& value, double& member) const {
    const std::optional<double> number = real(value);
    const bool allowed =
        number && ((*number >= low && *number <= high) || (or_zero && *number == 0.0));
    member = allowed ? *number : member;
    return allowed;
}

std::string RealsOrAuto::allowed() const {
    return "\"auto\" or " + Reals{low, high}.allowed();
}

std::string RealsOrAuto::schema() const {
    return any_of_schema(R"({"const": "auto"})", Reals{low, high}.schema());
}

bool RealsOrAuto::read(const Value& value, AutoReal& member) const {
    const auto* text = get<std::string>(value);
    if (text != nullptr && *text == "auto") {
        member = automatic;
        return true;
    }
    if (!Reals{low, high}.read(value, member.value)) {
        return false;
    }
    member.is_automatic = false;
    return true;
}

Value RealsOrAuto::write(const AutoReal& member) const {
    return member.is_automatic ? Value{std::string("auto")} : Value{member.value};
}

std::string Text::allowed() const {
    return or_empty ? "a string" : "a non-empty string";
}

std::string Text::schema() const {
    return or_empty ? R"({"type": "string"})" : R"({"type": "string", "minLength": 1})";
}

bool Text::read(const Value& value, std::string& member) const {
    return read_text(
        value, member, [this](const std::string& text) { return or_empty || !text.empty(); });
}

std::string Colors::allowed() const {
    return "a color \"#rrggbb\"";
}

std::string Colors::schema() const {
    return R"({"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"})";
}

bool Colors::read(const Value& value, std::string& member) const {
    return read_text(value, member, is_color);
}

std::string ColorLists::allowed() const {
    return "a list of colors \"#rrggbb\"";
}

std::string ColorLists::schema() const {
    return any_of_schema(Colors().schema(), list_schema(Colors().schema(), 0, 0));
}

bool ColorLists::read(const Value& value, std::vector<std::string>& member) const {
    const auto* list = get<Value::List>(value);
    std::vector<std::string> found;
    for (const Value& item : list != nullptr ? *list : Value::List{value}) {
        if (!Colors().read(item, found.emplace_back())) {
            return false;
        }
    }
    member = std::move(found);
    return true;
}

Value ColorLists::write(const std::vector<std::string>& member) const {
    return list_of(member);
}

std::string Words::allowed() const {
    return (list.size() > 1 ? "one of " : "") + quoted(list);
}

std::string Words::schema() const {
    return fmt::format(R"({{"enum": [{}]}})", quoted(list));
}

bool Words::read(const Value& value, std::string& member) const {
    return read_text(
        value, member, [this](const std::string& text) { return contains(list, text); });
}

std::string WordLists::allowed() const {
    return fmt::format("a list, without duplicates, of {}", quoted(list));
}

std::string WordLists::schema() const {
    const std::string word = Words{list}.schema();
    return any_of_schema(
        word,
        fmt::format(R"({{"type": "array", "items": {}, "minItems": 1, "uniqueItems": true}})",
                    word));
}

bool WordLists::read(const Value& value, std::vector<std::string>& member) const {
    const auto* items = get<Value::List>(value);
    std::vector<std::string> found;
    for (const Value& item : items != nullptr ? *items : Value::List{value}) {
        std::string word;
        if (!Words{list}.read(item, word) || contains(found, word)) {
            return false;
        }
        found.push_back(std::move(word));
    }
    if (found.empty()) {
        return false;
    }
    member = std::move(found);
    return true;
}

Value WordLists::write(const std::vector<std::string>& member) const {
    return list_of(member);
}

}  // namespace foam::texgen
