// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/random_variations.h"

#include "core/foam/random.h"
#include "texgen/preset/varied_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

constexpr const char* kSeedKey = "foam.seed";

/// Returns the keys in preset.vary, preceded by foam.seed unless they contain it.
std::vector<KeyValues> drawn_keys(const Preset& preset) {
    std::vector<KeyValues> keys = varied_keys(preset);
    if (keys.empty()) {
        throw PresetError(fmt::format(
            "preset '{}' has no list of keys for --random; its key preset.vary is empty, and may "
            "be a list such as [\"foam.lloyd=0,1,4\", \"loop.amplitude=0.1..0.4\"]",
            preset.name));
    }
    if (std::ranges::find(keys, kSeedKey, &KeyValues::key) == keys.end()) {
        keys.insert(keys.begin(), {.key = kSeedKey, .values = {NumberRange{1.0, kMaxRandomSeed}}});
    }
    return keys;
}

/// Returns the values of a key. Each range with a count is replaced by its numbers.
std::vector<std::variant<Value, NumberRange>> expanded(const KeyValues& varied) {
    std::vector<std::variant<Value, NumberRange>> values;
    for (const auto& value : varied.values) {
        const auto* const range = std::get_if<NumberRange>(&value);
        if (range != nullptr && range->count) {
            const std::vector<Value> numbers = numbers_of(*range);
            values.insert(values.end(), numbers.begin(), numbers.end());
        } else {
            values.push_back(value);
        }
    }
    return values;
}

/// Draws a value. Always takes two random numbers.
Value drawn_value(const KeyValues& varied, Random& random) {
    const auto values = expanded(varied);
    const std::uint64_t index = random.below(values.size());
    const double fraction = random.uniform();
    const auto& chosen = values[static_cast<std::size_t>(index)];
    const auto* const range = std::get_if<NumberRange>(&chosen);
    return range != nullptr ? number_at(varied, *range, fraction) : std::get<Value>(chosen);
}

}  // namespace

std::vector<Variation> random_variations(const Preset& preset, const RandomDraw& draw) {
    const std::vector<KeyValues> keys = drawn_keys(preset);
    if (std::ranges::all_of(
            keys, [&](const KeyValues& varied) { return draw.fixed.contains(varied.key); })) {
        throw PresetError("--random has no key to vary, because --set gives all of them");
    }
    Random random(draw.seed);
    std::vector<Variation> variations(static_cast<std::size_t>(draw.count));
    for (Variation& variation : variations) {
        for (const KeyValues& varied : keys) {
            Value value = drawn_value(varied, random);
            if (!draw.fixed.contains(varied.key)) {
                variation.assignments.push_back({fmt::format("preset.vary of '{}'", preset.name),
                                                 varied.key,
                                                 std::move(value)});
            }
        }
    }
    return variations;
}

}  // namespace foam::texgen
