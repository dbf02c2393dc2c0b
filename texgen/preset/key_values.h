// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

/// A range of numbers, both ends included.
struct NumberRange {
    double low = 0.0;
    double high = 0.0;
    std::optional<int> count{};  // if set, the range stands for this many evenly spaced numbers
};

/// A key and the values that it may take: an argument of `--sweep`, or an item of preset.vary.
struct KeyValues {
    std::string key;                                       // path, such as "foam.lloyd"
    std::vector<std::variant<Value, NumberRange>> values;  // at least one
};

/// The largest count of a range, of values of a sweep, of combinations of several sweeps, and of
/// random variations.
inline constexpr int kMaxValues = 400;

/// Parses KEY=VALUES. VALUES are separated by commas; commas within brackets or quotes do not
/// separate. Spaces around the key and around a value are ignored. LOW..HIGH is a range of numbers,
/// and LOW..HIGH:COUNT a range with a count from 2 to kMaxValues. Throws std::invalid_argument if
/// the text has another form. Does not check whether the key exists and allows the values.
KeyValues parse_key_values(std::string_view text);

/// Returns a number as a value. The number is rounded to twelve significant digits, which hides
/// rounding errors as in 0.30000000000000004. If the number has more than twelve digits before the
/// point and its magnitude is below 2^53, it is rounded to a whole number instead. The value is an
/// integer if the rounded number is whole and its magnitude is below 2^53, and a real otherwise.
Value number_value(double number);

/// Returns the evenly spaced numbers of a range with a count, from `low` to `high`.
std::vector<Value> numbers_of(const NumberRange& range);

}  // namespace foam::texgen
