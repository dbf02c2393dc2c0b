// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/varied_keys.h"

#include "texgen/preset/preset_keys.h"
#include "texgen/preset/rejection.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>

namespace foam::texgen {

namespace {

// These tables do not change what a picture shows.
constexpr std::array<std::string_view, 2> kExcludedTables = {"preset", "output"};

// A seed is no quantity, so it is not rounded.
constexpr std::string_view kSeedKey = "foam.seed";

const Key<Preset>& key_of(const std::string& path) {
    if (const Key<Preset>* const key = find_key(path)) {
        return *key;
    }
    const std::string_view meant = nearest_key(path);
    throw std::invalid_argument(
        fmt::format("'{}' is not a key{}",
                    path,
                    meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)));
}

void check_value(const Key<Preset>& key, const Value& value) {
    Preset scratch;
    if (!key.read(value, scratch)) {
        throw std::invalid_argument(
            fmt::format("{} = {}: must be {}", key.path, to_toml(value), key.allowed));
    }
}

/// Returns true if the key stores the number as an integer. Precondition: the key allows the
/// number.
bool takes_whole_numbers(const Key<Preset>& key, double number) {
    Preset scratch;
    key.read(number_value(number), scratch);
    const std::optional<Value> stored = key.write(scratch);
    return stored && std::holds_alternative<std::int64_t>(stored->data);
}

/// Returns the number rounded to a multiple of a power of ten. The power is chosen such that a
/// range of this width has 20 to 200 different multiples. If `whole` is true and the width is below
/// 20, the number is rounded to a whole number instead.
double rounded(double number, double width, bool whole) {
    constexpr double kMinMultiples = 20.0;
    constexpr double kTen = 10.0;
    constexpr double kMaxFactor = 1e9;
    double scale = 1.0;
    while (!whole && width * scale < kMinMultiples && scale < kMaxFactor) {
        scale *= kTen;
    }
    double step = 1.0;
    while (width >= kMinMultiples * kTen * step && step < kMaxFactor) {
        step *= kTen;
    }
    return std::round(number * scale / step) * step / scale;
}

void check_range(const Key<Preset>& key, const KeyValues& varied, const NumberRange& range) {
    if (range.count) {
        for (const Value& value : numbers_of(range)) {
            check_value(key, value);
        }
        return;
    }
    if (range.low >= range.high) {
        throw std::invalid_argument(fmt::format(
            "{} = {}..{}: the first number must be the smaller", key.path, range.low, range.high));
    }
    check_value(key, number_value(range.low));
    check_value(key, number_value(range.high));
    // Numbers between two allowed numbers can be forbidden: foam.area_ratio, for example, is 0 or
    // at least 1. Therefore, numbers throughout the range are checked, too.
    constexpr int kSamples = 64;
    for (int k = 0; k <= kSamples; ++k) {
        check_value(key, number_at(varied, range, static_cast<double>(k) / kSamples));
    }
}

}  // namespace

KeyValues parse_varied_key(std::string_view text) {
    KeyValues varied;
    try {
        varied = parse_key_values(text);
        const Key<Preset>& key = key_of(varied.key);
        if (std::ranges::find(kExcludedTables, key.table()) != kExcludedTables.end()) {
            throw std::invalid_argument(fmt::format("{} does not change pictures", key.path));
        }
        for (const auto& value : varied.values) {
            if (const auto* const range = std::get_if<NumberRange>(&value)) {
                check_range(key, varied, *range);
            } else {
                check_value(key, std::get<Value>(value));
            }
        }
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("'{}': {}", text, error.what()));
    }
    return varied;
}

std::vector<KeyValues> varied_keys(const Preset& preset) {
    std::vector<KeyValues> keys;
    for (const std::string& text : preset.vary) {
        keys.push_back(parse_key_values(text));
    }
    return keys;
}

void check_varied_keys(std::span<const Assignment> assignments, const Preset& preset) {
    const auto last = std::find_if(assignments.rbegin(),
                                   assignments.rend(),
                                   [](const Assignment& one) { return one.key == "preset.vary"; });
    if (last == assignments.rend()) {
        return;
    }
    std::set<std::string> keys;
    for (const std::string& text : preset.vary) {
        try {
            const KeyValues varied = parse_varied_key(text);
            if (!keys.insert(varied.key).second) {
                reject(*last, fmt::format("has {} twice; give all values in one text", varied.key));
            }
        } catch (const std::invalid_argument& error) {
            reject(*last, error.what());
        }
    }
}

Value number_at(const KeyValues& varied, const NumberRange& range, double fraction) {
    const double width = range.high - range.low;
    const bool whole = takes_whole_numbers(*find_key(varied.key), range.low);
    // The interval of fractions that gives a whole number is equally long for each whole number.
    const double number =
        whole ? range.low + std::floor(fraction * (width + 1.0)) : range.low + fraction * width;
    const double result = varied.key == kSeedKey ? number : rounded(number, width, whole);
    return number_value(std::clamp(result, range.low, range.high));
}

}  // namespace foam::texgen
