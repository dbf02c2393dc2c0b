// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/sweep.h"

#include "texgen/bake/frame_range.h"
#include "texgen/preset/key_values.h"

#include <fmt/core.h>

#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

[[noreturn]] void reject(const std::string& location, std::string_view reason) {
    throw PresetError(fmt::format("{}: {}", location, reason));
}

KeyValues parsed_argument(const std::string& argument, const std::string& location) {
    try {
        return parse_key_values(argument);
    } catch (const std::invalid_argument& error) {
        reject(location, error.what());
    }
}

/// Returns the values that one part of the argument stands for.
std::vector<Value> values_of(const std::variant<Value, NumberRange>& part,
                             const std::string& location) {
    if (const auto* const value = std::get_if<Value>(&part)) {
        return {*value};
    }
    const auto& range = std::get<NumberRange>(part);
    if (!range.count) {
        reject(location,
               fmt::format("{0}..{1} needs a COUNT, as in {0}..{1}:4", range.low, range.high));
    }
    return numbers_of(range);
}

Sweep checked(Sweep sweep, const std::string& location) {
    if (sweep.values.size() > kMaxValues) {
        reject(
            location,
            fmt::format("has {} values; at most {} are allowed", sweep.values.size(), kMaxValues));
    }
    return sweep;
}

}  // namespace

Sweep read_sweep(const std::string& argument) {
    const std::string location = "--sweep " + argument;
    const KeyValues parsed = parsed_argument(argument, location);
    Sweep sweep{.key = parsed.key, .values = {}};
    for (const auto& value : parsed.values) {
        for (const Value& one : values_of(value, location)) {
            sweep.values.push_back({location, sweep.key, one});
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
        reject(location,
               fmt::format("must be a list of seeds from 1 to {}, such as 1-12 or 3,7,20-24",
                           kLastFrame));
    }
    return checked(std::move(sweep), location);
}

}  // namespace foam::texgen
