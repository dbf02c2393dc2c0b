// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/conditions.h"

#include "texgen/keys/value.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

// Returns the value of a key as conditions name it: a word, or a number as TOML writes it.
// Precondition: the key exists and is set.
std::string value_of(std::string_view path, const Preset& preset) {
    const std::optional<Value> value = find_key(path)->write(preset);
    const std::string* const word = std::get_if<std::string>(&value->data);
    return word != nullptr ? *word : to_toml(*value);
}

// Returns an unmet condition of a key, because of which the key has no effect. Returns nullptr if
// all conditions are met.
const Condition* unmet(const KeyInfo& key, const Preset& preset) {
    for (const std::optional<Condition>* condition : {&key.condition, &key.use}) {
        if (condition->has_value() && !is_met(**condition, preset)) {
            return &**condition;
        }
    }
    return nullptr;
}

}  // namespace

bool is_met(const Condition& condition, const Preset& preset) {
    return condition.allows(value_of(condition.key, preset));
}

std::vector<std::string> unused_keys(const Preset& preset,
                                     std::span<const Assignment> assignments) {
    std::vector<std::string> lines;
    for (const Assignment& assignment : assignments) {
        const Key<Preset>* const key = find_key(assignment.key);
        const Condition* const condition = key != nullptr ? unmet(*key, preset) : nullptr;
        if (condition == nullptr) {
            continue;
        }
        const Condition present{condition->key, {value_of(condition->key, preset)}};
        std::string line = fmt::format("{} has no effect with {}", key->path, text_of(present));
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

std::string describe_conditions(const KeyInfo& key) {
    std::string text;
    if (key.condition) {
        text += fmt::format("    only with {}\n", text_of(*key.condition));
    }
    if (key.use) {
        text += fmt::format(
            "    no effect {} {}\n", key.use->excludes ? "with" : "unless", text_of(*key.use));
    }
    return text;
}

}  // namespace foam::texgen
