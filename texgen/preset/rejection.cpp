// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/rejection.h"

#include "core/files/shown_text.h"
#include "texgen/keys/nearest.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <variant>

namespace foam::texgen {

namespace {

// Finds the first text that is not one of the words that the key allows. The text is the value
// itself or, if the value is a list, one of its items. Returns a suggestion for this text, or an
// empty text if no word is similar.
std::string suggested_word(const Value& value, const KeyInfo& key) {
    const auto* list = std::get_if<Value::List>(&value.data);
    for (const Value& item : list != nullptr ? *list : Value::List{value}) {
        const auto* text = std::get_if<std::string>(&item.data);
        if (text != nullptr &&
            std::find(key.words.begin(), key.words.end(), *text) == key.words.end()) {
            return did_you_mean(*text, key.words);
        }
    }
    return {};
}

}  // namespace

void reject(const Assignment& assignment, std::string_view reason) {
    throw PresetError(fmt::format("{}: key '{}' = {}: {}",
                                  assignment.location,
                                  assignment.key,
                                  cut_text(to_toml(assignment.value)),
                                  reason));
}

void reject_last(std::span<const Assignment> assignments,
                 std::initializer_list<std::string_view> keys,
                 std::string_view reason) {
    const auto last =
        std::find_if(assignments.rbegin(), assignments.rend(), [&](const Assignment& assignment) {
            return std::find(keys.begin(), keys.end(), assignment.key) != keys.end();
        });
    reject(last != assignments.rend() ? *last : assignments.back(), reason);
}

void reject_value(const Assignment& assignment, const KeyInfo& key) {
    const std::string fault = key.fault ? key.fault(assignment.value) : "";
    const std::string suggestion = suggested_word(assignment.value, key);
    // If a word is suggested, the value is probably a misspelled word. The fault, for example the
    // reason why the value is no valid polygon, is then left out.
    const bool shows_fault = !fault.empty() && suggestion.empty();
    reject(assignment,
           fmt::format("must be {}{}{}{}",
                       key.allowed,
                       suggestion,
                       shows_fault ? "; " : "",
                       shows_fault ? fault : ""));
}

void reject_unknown(const Assignment& assignment, std::string_view meant) {
    const bool holds_table = std::holds_alternative<Value::Table>(assignment.value.data);
    reject(assignment,
           fmt::format("unknown {}; {}",
                       holds_table ? "table" : "key",
                       meant.empty() ? "'foamtex presets keys' lists all keys"
                                     : fmt::format("did you mean '{}'?", meant)));
}

}  // namespace foam::texgen
