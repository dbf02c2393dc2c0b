// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/color_scale.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <variant>

namespace foam::texgen {

namespace {

LinearRgb mixed_in_srgb(const LinearRgb& a, const LinearRgb& b, double part) {
    const auto mix = [&](double from, double to) {
        return srgb_to_linear(std::lerp(linear_to_srgb(from), linear_to_srgb(to), part));
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

// A color of a list, and its position if the list gives one.
struct Stop {
    LinearRgb color;
    std::optional<double> position{};
};

Stop parse_stop(const std::string& text) {
    const std::size_t at = text.find('@');
    Stop stop{to_linear(parse_color(text.substr(0, at)))};
    if (at != std::string::npos) {
        const char* const begin = text.data() + at + 1;
        const char* const end = text.data() + text.size();
        double position = 0.0;
        const auto [rest, error] = std::from_chars(begin, end, position);
        if (error != std::errc{} || rest != end || !(position >= 0.0 && position <= 1.0)) {
            throw std::invalid_argument(fmt::format(
                "color '{}': the position after '@' must be a number from 0 to 1", text));
        }
        stop.position = position;
    }
    return stop;
}

// Spaces the positions between two known ones evenly.
void space_evenly(std::vector<double>& positions, std::size_t first, std::size_t last) {
    const double step = (positions[last] - positions[first]) / static_cast<double>(last - first);
    for (std::size_t k = first + 1; k < last; ++k) {
        positions[k] = positions[first] + step * static_cast<double>(k - first);
    }
}

// Returns the positions of all colors.
std::vector<double> positions_of(const std::vector<Stop>& stops, ScaleEnd end) {
    const std::size_t count = stops.size() + (end == ScaleEnd::AfterLastColor ? 1 : 0);
    std::vector<double> positions(count, 0.0);
    positions.front() = stops.front().position.value_or(0.0);
    std::size_t known = 0;
    for (std::size_t k = 1; k < count; ++k) {
        const std::optional<double> given = k < stops.size() ? stops[k].position : std::nullopt;
        if (!given && k + 1 < count) {
            continue;
        }
        positions[k] = given.value_or(1.0);
        if (positions[k] < positions[known]) {
            throw std::invalid_argument("positions of colors must not descend");
        }
        space_evenly(positions, known, k);
        known = k;
    }
    positions.resize(stops.size());
    return positions;
}

// Returns the reason why a list of texts is not a valid list of colors; empty if it is valid.
std::string fault_of(const std::vector<std::string>& list) {
    try {
        parse_gradient(list, ScaleEnd::LastColor);
        return {};
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

// Returns the texts of a value that is a text or a list of texts, or nullopt for other values.
std::optional<std::vector<std::string>> texts_of(const Value& value) {
    const auto* const list = std::get_if<Value::List>(&value.data);
    std::vector<std::string> texts;
    for (const Value& item : list != nullptr ? *list : Value::List{value}) {
        const auto* const text = std::get_if<std::string>(&item.data);
        if (text == nullptr) {
            return std::nullopt;
        }
        texts.push_back(*text);
    }
    return texts;
}

}  // namespace

std::string Gradients::allowed() const {
    return "a list of colors \"#rrggbb\", each of which may be followed by its position from 0 to "
           "1, such as \"#ff8000@0.25\"";
}

std::string Gradients::schema() const {
    // A position from 0 to 1 in decimals, or any number with an exponent. The pattern does not
    // check that a number with an exponent is from 0 to 1.
    constexpr std::string_view kPosition =
        R"(0+(\\.[0-9]*)?|\\.[0-9]+|0*1(\\.0*)?|[0-9.]+[eE][-+]?[0-9]+)";
    const std::string item =
        fmt::format(R"({{"type": "string", "pattern": "^#[0-9a-fA-F]{{6}}(@({}))?$"}})", kPosition);
    return any_of_schema(item, list_schema(item, 0, 0));
}

bool Gradients::read(const Value& value, std::vector<std::string>& member) const {
    std::optional<std::vector<std::string>> texts = texts_of(value);
    if (!texts || !fault_of(*texts).empty()) {
        return false;
    }
    member = *std::move(texts);
    return true;
}

std::string Gradients::fault(const Value& value) const {
    const std::optional<std::vector<std::string>> texts = texts_of(value);
    return texts ? fault_of(*texts) : std::string();
}

Gradient parse_gradient(const std::vector<std::string>& list, ScaleEnd end) {
    std::vector<Stop> stops;
    Gradient gradient;
    for (const std::string& text : list) {
        stops.push_back(parse_stop(text));
        gradient.colors.push_back(stops.back().color);
    }
    if (std::ranges::any_of(stops, [](const Stop& stop) { return stop.position.has_value(); })) {
        gradient.positions = positions_of(stops, end);
    }
    return gradient;
}

LinearRgb blended(const Gradient& gradient, double position) {
    const std::vector<double>& positions = gradient.positions;
    if (positions.empty()) {
        return blended(gradient.colors, position);
    }
    const auto above =
        static_cast<std::size_t>(std::ranges::upper_bound(positions, position) - positions.begin());
    if (above == 0 || above == positions.size()) {
        return above == 0 ? gradient.colors.front() : gradient.colors.back();
    }
    const double part =
        (position - positions[above - 1]) / (positions[above] - positions[above - 1]);
    return mixed_in_srgb(gradient.colors[above - 1], gradient.colors[above], part);
}

LinearRgb picked(const Gradient& gradient, double position) {
    if (gradient.positions.empty()) {
        return picked(gradient.colors, position);
    }
    const auto after = std::ranges::upper_bound(gradient.positions, position);
    const auto index = static_cast<std::size_t>(
        std::max<std::ptrdiff_t>(0, after - gradient.positions.begin() - 1));
    return gradient.colors[index];
}

std::vector<LinearRgb> parse_colors(const std::vector<std::string>& colors) {
    std::vector<LinearRgb> parsed;
    parsed.reserve(colors.size());
    for (const std::string& color : colors) {
        parsed.push_back(to_linear(parse_color(color)));
    }
    return parsed;
}

LinearRgb blended(const std::vector<LinearRgb>& colors, double position) {
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(scaled), colors.size() - 1);
    const auto above = std::min(below + 1, colors.size() - 1);
    const double part = scaled - static_cast<double>(below);
    return mixed_in_srgb(colors[below], colors[above], part);
}

LinearRgb picked(const std::vector<LinearRgb>& colors, double position) {
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(colors.size());
    return colors[std::min(static_cast<std::size_t>(scaled), colors.size() - 1)];
}

}  // namespace foam::texgen
