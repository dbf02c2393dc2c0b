// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/sweep.h"

#include "texgen/bake/frame_range.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace foam::texgen {

namespace {

[[noreturn]] void reject(const std::string& location, std::string_view reason) {
    throw PresetError(fmt::format("{}: {}", location, reason));
}

/// Splits a text at the commas that are outside of brackets and quotes.
std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        }
        if (c == ',' && depth == 0 && quote == 0) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

/// Returns the number that a whole text represents.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

/// Returns the numbers of LOW..HIGH:COUNT as texts; nullopt if the text has no "..".
std::optional<std::vector<std::string>> numbers_of_range(std::string_view text,
                                                         const std::string& location) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos || text.front() == '"') {
        return std::nullopt;
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::size_t colon = std::min(text.find(':', dots), text.size());
    const double low = number_in<double>(text.substr(0, dots)).value_or(kNone);
    const double high = number_in<double>(text.substr(dots + 2, colon - dots - 2)).value_or(kNone);
    const int count = number_in<int>(text.substr(std::min(colon + 1, text.size()))).value_or(0);
    if (!std::isfinite(low) || !std::isfinite(high) || count < 2 || count > kLargestSweep) {
        reject(location,
               fmt::format(
                   "'{}' must be LOW..HIGH:COUNT, such as 0.1..0.4:4, with a COUNT from 2 to {}",
                   text,
                   kLargestSweep));
    }
    std::vector<std::string> numbers;
    for (int k = 0; k < count; ++k) {
        const double fraction = static_cast<double>(k) / (count - 1);
        // Twelve digits hide the rounding errors of the interpolation, as in 0.30000000000000004.
        numbers.push_back(fmt::format("{:.12g}", low + (high - low) * fraction));
    }
    return numbers;
}

Sweep checked(Sweep sweep, const std::string& location) {
    if (sweep.values.size() > kLargestSweep) {
        reject(location,
               fmt::format(
                   "has {} values; at most {} are allowed", sweep.values.size(), kLargestSweep));
    }
    return sweep;
}

}  // namespace

Sweep read_sweep(const std::string& argument) {
    const std::string location = "--sweep " + argument;
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == argument.size()) {
        reject(location, "must be KEY=VALUES, such as foam.lloyd=0,1,2 or loop.current=0..0.6:4");
    }
    Sweep sweep{.key = argument.substr(0, equals), .values = {}};
    for (const std::string& part : split(std::string_view(argument).substr(equals + 1))) {
        if (part.empty()) {
            reject(location, "has an empty value");
        }
        for (const std::string& text :
             numbers_of_range(part, location).value_or(std::vector{part})) {
            sweep.values.push_back({location, sweep.key, read_value(text)});
        }
    }
    return checked(std::move(sweep), location);
}

Sweep read_seeds(const std::string& argument) {
    const std::string location = "--seeds " + argument;
    Sweep sweep{.key = "foam.seed", .values = {}};
    try {
        for (const int seed : parse_frame_range(argument)) {
            sweep.values.push_back({location, sweep.key, {static_cast<std::int64_t>(seed)}});
        }
    } catch (const std::invalid_argument&) {
        reject(location, "must be a range of seeds from 1, such as 1-12 or 3,7,20-24");
    }
    return checked(std::move(sweep), location);
}

}  // namespace foam::texgen
