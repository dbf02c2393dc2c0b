// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation_labels.h"

#include "texgen/preset/preset_io.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <variant>

namespace foam::texgen {

namespace {

std::string_view name_of(std::string_view key) {
    return key.substr(key.find('.') + 1);
}

/// Returns the shortest name of a key that no other key of the variation has.
std::string unique_name(const std::string& key, const Variation& variation) {
    const std::string_view name = name_of(key);
    const auto same = std::ranges::count_if(
        variation.assignments, [&](const Assignment& one) { return name_of(one.key) == name; });
    return same > 1 ? key : std::string(name);
}

/// Returns the colors of a value that consists of colors; otherwise an empty list.
std::vector<Srgb8> colors_in(const Value& value) {
    const auto* const list = std::get_if<Value::List>(&value.data);
    std::vector<Srgb8> colors;
    for (const Value& item : list != nullptr ? *list : Value::List{value}) {
        const auto* const text = std::get_if<std::string>(&item.data);
        try {
            colors.push_back(parse_color(text != nullptr ? *text : ""));
        } catch (const std::invalid_argument&) {
            return {};
        }
    }
    return colors;
}

/// Returns a value in the notation of TOML, but a string without its quotes.
std::string text_of(const Value& value) {
    const auto* const word = std::get_if<std::string>(&value.data);
    return word != nullptr ? *word : to_toml(value);
}

}  // namespace

std::string label_text(const Variation& variation) {
    std::string text;
    for (const Assignment& one : variation.assignments) {
        text +=
            (text.empty() ? "" : ", ") + unique_name(one.key, variation) + '=' + to_toml(one.value);
    }
    return text;
}

std::vector<ThumbnailLabel> picture_labels(const Variation& variation) {
    std::vector<ThumbnailLabel> labels;
    for (const Assignment& one : variation.assignments) {
        std::vector<Srgb8> colors = colors_in(one.value);
        const std::string value = colors.empty() ? '=' + text_of(one.value) : "";
        labels.push_back({unique_name(one.key, variation) + value, std::move(colors)});
    }
    return labels;
}

}  // namespace foam::texgen
