// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/key_values.h"

#include "core/files/content_text.h"
#include "texgen/preset/assignment.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace foam::texgen {

namespace {

/// Splits a text at the commas that are outside of brackets and quotes.
std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (c == '"' || c == '\'') {
            k = end_of_string(text, k);
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && depth == 0) {
            parts.push_back(text.substr(begin, k - begin));
            begin = k + 1;
        }
    }
    parts.push_back(text.substr(begin));
    return parts;
}

/// Returns the number that the whole text represents, or nullopt if it is not a number.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

/// Parses LOW..HIGH or LOW..HIGH:COUNT. Returns nullopt if the text has no "..", or if a quote or
/// an opening bracket precedes it. Throws std::invalid_argument if a text with ".." has another
/// form.
std::optional<NumberRange> range_in(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos || text.find_first_of("\"'[{") < dots) {
        return std::nullopt;
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::size_t colon = std::min(text.find(':', dots), text.size());
    NumberRange range{
        .low = number_in<double>(text.substr(0, dots)).value_or(kNone),
        .high = number_in<double>(text.substr(dots + 2, colon - dots - 2)).value_or(kNone)};
    if (colon < text.size()) {
        range.count = number_in<int>(text.substr(colon + 1)).value_or(0);
    }
    const int count = range.count.value_or(2);
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || count < 2 ||
        count > kMaxValues) {
        throw std::invalid_argument(fmt::format(
            "'{}' must be LOW..HIGH or LOW..HIGH:COUNT, such as 0.1..0.4:4, with a COUNT from 2 "
            "to {}",
            text,
            kMaxValues));
    }
    return range;
}

}  // namespace

KeyValues parse_key_values(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view key = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || key.empty() || equals + 1 == text.size()) {
        throw std::invalid_argument(
            "must be KEY=VALUES, such as foam.lloyd=0,1,2 or loop.current=0..0.6:4");
    }
    KeyValues parsed{.key = std::string(key), .values = {}};
    for (const std::string_view spaced : split(text.substr(equals + 1))) {
        const std::string part(trimmed(spaced));
        if (part.empty()) {
            throw std::invalid_argument("has an empty value");
        }
        if (const std::optional<NumberRange> range = range_in(part)) {
            parsed.values.emplace_back(*range);
        } else {
            parsed.values.emplace_back(read_value(part));
        }
    }
    return parsed;
}

Value number_value(double number) {
    constexpr double kAllWhole = 1e11;  // from 1e11 on, numbers of twelve digits are whole
    constexpr double kMaxExact = 0x1p53;
    const double magnitude = std::abs(number);
    if (magnitude >= kAllWhole && magnitude < kMaxExact) {
        return {static_cast<std::int64_t>(std::round(number))};
    }
    return read_value(fmt::format("{:.12g}", number));
}

std::vector<Value> numbers_of(const NumberRange& range) {
    std::vector<Value> numbers;
    const int count = range.count.value_or(2);
    for (int k = 0; k < count; ++k) {
        const double fraction = static_cast<double>(k) / (count - 1);
        numbers.push_back(number_value(range.low + (range.high - range.low) * fraction));
    }
    return numbers;
}

}  // namespace foam::texgen
