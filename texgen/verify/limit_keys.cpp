// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/limit_keys.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr double kMaxLimit = 1e300;
constexpr double kMaxAngle = 180.0;
constexpr std::int64_t kMaxPixels = 1'000'000'000'000;
constexpr Reals kDifferences{0.0, kMaxLimit};

// Returns the number that the whole text represents, or nullopt.
template <class Number>
std::optional<Number> parsed(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

// Parses a limit such as "99.9=0.01". Returns nullopt if the text is not a limit that
// PercentileLimits::allowed() describes.
std::optional<PercentileLimit> percentile_limit(std::string_view text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const auto percent = parsed<double>(text.substr(0, equals));
    const auto difference = parsed<double>(text.substr(std::min(equals + 1, text.size())));
    const bool allowed = percent && difference && *percent > 0.0 && *percent <= 100.0 &&
                         *difference >= 0.0 && *difference <= kMaxLimit;
    return allowed ? std::optional(PercentileLimit{*percent, *difference}) : std::nullopt;
}

// Returns the keys of the limits of one severity, "fail" or "warn". "{}" in a path stands for the
// severity.
Keys<DifferenceLimits> severity_keys() {
    using L = DifferenceLimits;
    return {
        key("{}",
            Maybe<Reals>{kDifferences},
            "largest allowed difference of a pixel (default 1e-6, or none if the rms, a percentile "
            "or the angle is limited)",
            &L::sample),
        key("{}_percent",
            Reals{0.0, 100.0},
            "percentage of pixels that may exceed the limits of differences and angles (default 0)",
            &L::allowed_percent),
        key("{}_pixels",
            Integers{0, kMaxPixels},
            "number of pixels that may exceed the limits of differences and angles (default 0)",
            &L::allowed_pixels),
        key("hard_{}",
            Maybe<Reals>{kDifferences},
            "largest allowed difference of a pixel, without exceptions",
            &L::hard),
        key("{}_rms",
            Maybe<Reals>{kDifferences},
            "largest allowed root mean square of the differences of all samples",
            &L::rms),
        key("{}_percentile",
            PercentileLimits{},
            "at least P percent of the pixels must differ by at most T; several limits are "
            "separated by commas",
            &L::percentiles),
        key("{}_angle",
            Maybe<Reals>{{0.0, kMaxAngle}},
            "largest allowed angle between the normals of a pixel of a normal map, in degrees",
            &L::angle)
            .in("degrees"),
    };
}

// Returns the keys of the limits of a severity. `limits` is the member of CompareLimits that
// contains these limits.
Keys<CompareLimits> keys_of(std::string_view severity, DifferenceLimits CompareLimits::*limits) {
    Keys<CompareLimits> keys = nested_keys("", limits, severity_keys());
    for (Key<CompareLimits>& key : keys) {
        key.path.replace(key.path.find("{}"), 2, severity);
    }
    return keys;
}

}  // namespace

std::string PercentileLimits::allowed() const {
    return "\"P=T\" (at least P percent of the pixels differ by at most T), or several, separated "
           "by commas, with P above 0 and at most 100, and T at least 0";
}

std::string PercentileLimits::schema() const {
    return R"({"type": "string"})";
}

bool PercentileLimits::read(const Value& value, std::vector<PercentileLimit>& member) const {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) {
        return false;
    }
    std::vector<PercentileLimit> limits;
    for (std::size_t begin = 0; begin <= text->size();) {
        const std::size_t end = std::min(text->find(',', begin), text->size());
        const auto limit = percentile_limit(std::string_view(*text).substr(begin, end - begin));
        if (!limit) {
            return false;
        }
        limits.push_back(*limit);
        begin = end + 1;
    }
    member = limits;
    return true;
}

std::optional<Value> PercentileLimits::write(const std::vector<PercentileLimit>& member) const {
    std::string text;
    for (const auto& [percent, difference] : member) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ",", percent, difference);
    }
    return text.empty() ? std::nullopt : std::optional(Value{text});
}

const Keys<CompareLimits>& limit_keys() {
    static const Keys<CompareLimits> keys =
        joined({keys_of("fail", &CompareLimits::fail), keys_of("warn", &CompareLimits::warn)});
    return keys;
}

bool is_warning_key(const KeyInfo& key) {
    return key.path.find("warn") != std::string::npos;
}

bool is_angle_key(const KeyInfo& key) {
    return key.path.ends_with("_angle");
}

std::string option_name(const KeyInfo& key) {
    std::string name = "--" + key.path;
    std::ranges::replace(name, '_', '-');
    return name;
}

Value value_of_argument(const std::string& text) {
    if (const auto integer = parsed<std::int64_t>(text)) {
        return {*integer};
    }
    const auto real = parsed<double>(text);
    return real ? Value{*real} : Value{text};
}

}  // namespace foam::texgen
