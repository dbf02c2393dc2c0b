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

// Returns an unmet condition because of which a key has no effect, or nullptr if all conditions are
// met. The condition KeyInfo::use is about the value of another key. If this other key has no
// effect itself, returns the unmet condition of the other key.
const Condition* unmet(const KeyInfo& key, const Preset& preset) {
    if (key.condition && !is_met(*key.condition, preset)) {
        return &*key.condition;
    }
    if (!key.use) {
        return nullptr;
    }
    const Key<Preset>& other = *find_key(key.use->key);
    const Condition* const unmet_by_other =
        other.use && !is_met(*other.use, preset) ? &*other.use : nullptr;
    return unmet_by_other != nullptr || is_met(*key.use, preset) ? unmet_by_other : &*key.use;
}

// Returns the present value of a key as a text, such as "lit.windows = 0".
std::string present_value(std::string_view path, const Preset& preset) {
    return text_of({path, {value_of(path, preset)}});
}

// Returns the values of other keys because of which dynamics.kappa has no effect, or an empty text
// if the key has an effect. Gas diffuses during the warm-up and, unless a loop returns the foam to
// its first state, in the time steps. If dynamics.kappa is 0, the result is empty, too, because the
// user then expects no diffusion.
std::string cause_of_no_diffusion(const Preset& preset) {
    if (preset.frames.warm_up > 0.0 || preset.coarsening.kappa == 0.0) {
        return {};
    }
    if (preset.loop.returns_to_start()) {
        return fmt::format("{} and {}",
                           present_value("loop.kind", preset),
                           present_value("frames.warm_up", preset));
    }
    return preset.frames.time_step > 0.0 ? ""
                                         : fmt::format("{} and {}",
                                                       present_value("frames.time_step", preset),
                                                       present_value("frames.warm_up", preset));
}

// Returns the values of other keys because of which a key has no effect, or an empty text if the
// key has an effect.
std::string cause_of_no_effect(const KeyInfo& key, const Preset& preset) {
    if (key.path == "dynamics.kappa") {
        return cause_of_no_diffusion(preset);
    }
    if (key.path == "vector.wrap" && preset.shape.kind == FoamKind::Patch) {
        return present_value("foam.domain", preset);  // only a tile of a torus can be cut
    }
    const Condition* const condition = unmet(key, preset);
    return condition != nullptr ? present_value(condition->key, preset) : "";
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
        const std::string cause = key != nullptr ? cause_of_no_effect(*key, preset) : "";
        if (cause.empty()) {
            continue;
        }
        std::string line = fmt::format("{} has no effect with {}", key->path, cause);
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
