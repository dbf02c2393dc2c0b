// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_io.h"

#include "texgen/keys/nearest.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/preset/conditions.h"
#include "texgen/preset/event_io.h"
#include "texgen/preset/loop_check.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/rejection.h"
#include "texgen/preset/varied_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kMaxAspect = 16;  // longer side of an image divided by the shorter side
constexpr std::string_view kEventTable = "event";

// Returns the table that a misspelled table most likely stands for (nearest). The key of a table in
// an array has a number, such as "evnt[1]".
std::string_view nearest_table(std::string_view key) {
    return nearest(key.substr(0, key.find('[')), preset_tables());
}

// Checks the value of one assignment and stores it in the preset.
void assign_one(Preset& preset, const Assignment& assignment) {
    if (is_event_key(assignment.key)) {
        assign_event(preset, assignment);
        return;
    }
    const Key<Preset>* key = find_key(assignment.key);
    const bool holds_table = std::holds_alternative<Value::Table>(assignment.value.data);
    if (holds_table && is_table(assignment.key)) {
        return;
    }
    if (key == nullptr && is_table(assignment.key)) {
        reject(assignment,
               fmt::format("is a table; 'foamtex presets keys {}' lists its keys", assignment.key));
    }
    if (key == nullptr) {
        reject_unknown(assignment,
                       holds_table ? nearest_table(assignment.key) : nearest_key(assignment.key));
    }
    if (!key->read(assignment.value, preset)) {
        reject_value(assignment, *key);
    }
}

// Returns the assignment that an error names: the last assignment to the key `first`. If `first` is
// not assigned, returns the last assignment to the key `second`. If `second` is not assigned
// either, returns the last of all assignments.
const Assignment& assignment_to_report(std::span<const Assignment> assignments,
                                       std::string_view first,
                                       std::string_view second) {
    for (const std::string_view key : {first, second}) {
        const auto last = std::find_if(assignments.rbegin(),
                                       assignments.rend(),
                                       [&](const Assignment& one) { return one.key == key; });
        if (last != assignments.rend()) {
            return *last;
        }
    }
    return assignments.back();
}

// Returns the value that a key has in the preset. Precondition: the key is set.
Value value_in(const Key<Preset>& key, const Preset& preset) {
    std::optional<Value> value = key.write(preset);
    assert(value.has_value());
    return *std::move(value);
}

// Checks the conditions of all keys. A key whose condition is not met has no effect, so it must
// keep its default.
void check_conditions(const Preset& preset, std::span<const Assignment> assignments) {
    for (const Key<Preset>& key : preset_keys()) {
        if (key.condition && !is_met(*key.condition, preset) && !key.is_default(preset)) {
            reject(assignment_to_report(assignments, key.path, key.condition->key),
                   fmt::format("{} is only allowed with {}", key.path, text_of(*key.condition)));
        }
    }
}

// Returns the number that a key has in the preset. Precondition: the key is numeric and set.
double number_of(const Key<Preset>& key, const Preset& preset) {
    constexpr double kMax = std::numeric_limits<double>::max();
    double number = 0.0;
    Reals{-kMax, kMax}.read(value_in(key, preset), number);
    return number;
}

// Checks that the number of the key `lower` is below the number of the key `upper`. Otherwise
// rejects the last assignment to either key. There is such an assignment, because the preset was
// valid before all of these assignments.
void check_upper_limit(const Key<Preset>& lower,
                       const Key<Preset>& upper,
                       const Preset& preset,
                       std::span<const Assignment> assignments) {
    const double low = number_of(lower, preset);
    const double high = number_of(upper, preset);
    if (low < high) {
        return;
    }
    for (auto last = assignments.rbegin(); last != assignments.rend(); ++last) {
        if (last->key == upper.path) {
            reject(*last, fmt::format("must be above {} = {}", lower.path, low));
        }
        if (last->key == lower.path) {
            reject(*last, fmt::format("must be below {} = {}", upper.path, high));
        }
    }
}

void check_upper_limits(const Preset& preset, std::span<const Assignment> assignments) {
    for (const Key<Preset>& key : preset_keys()) {
        if (key.upper_limit) {
            check_upper_limit(key, *find_key(*key.upper_limit), preset, assignments);
        }
    }
}

// Checks that the longer side of the image is at most kMaxAspect times the shorter side. A foam
// of few bubbles does not fit a very long torus.
void check_aspect(const Preset& preset, std::span<const Assignment> assignments) {
    const int shorter = std::min(preset.image.width, preset.image.height);
    const int longer = std::max(preset.image.width, preset.image.height);
    if (longer > kMaxAspect * shorter) {
        reject_last(
            assignments,
            {"image.size"},
            fmt::format("the longer side must be at most {} times the shorter side", kMaxAspect));
    }
}

// Checks that there is a picture if bubbles take their colors from one.
void check_picture(const Preset& preset, std::span<const Assignment> assignments) {
    const AlbedoOptions& albedo = preset.maps.albedo;
    if (albedo.color_by == ColorBy::Picture && !albedo.picture.is_set()) {
        reject_last(assignments,
                    {"albedo.picture", "albedo.color_by"},
                    "albedo.color_by = \"picture\" needs albedo.picture, the path of a picture");
    }
}

}  // namespace

void assign(Preset& preset, std::span<const Assignment> assignments) {
    for (const Assignment& assignment : assignments) {
        assign_one(preset, assignment);
    }
    check_conditions(preset, assignments);
    check_upper_limits(preset, assignments);
    check_aspect(preset, assignments);
    check_picture(preset, assignments);
    check_varied_keys(assignments, preset);
    check_events(preset, assignments);
    check_loop(preset, assignments);
}

Preset parse_preset(std::string_view toml, const std::string& name, const std::string& source) {
    Preset preset;
    preset.name = name;
    assign(preset, read_assignments(toml, source));
    return preset;
}

std::string to_toml(const Preset& preset) {
    std::string toml;
    std::string_view table;
    for (const Key<Preset>& key : preset_keys()) {
        if (key.written && !is_met(*key.written, preset)) {
            continue;
        }
        if (key.table() != table) {
            table = key.table();
            toml += fmt::format("{}[{}]\n", toml.empty() ? "" : "\n", table);
        }
        toml += fmt::format("{} = {}\n", key.name(), to_toml(value_in(key, preset)));
    }
    return toml + events_to_toml(preset);
}

std::vector<std::string_view> preset_tables() {
    std::vector<std::string_view> tables;
    for (const KeyInfo& key : preset_keys()) {
        if (tables.empty() || tables.back() != key.table()) {
            tables.push_back(key.table());
        }
    }
    tables.push_back(kEventTable);
    return tables;
}

std::string describe_keys() {
    std::string text;
    for (const std::string_view table : preset_tables()) {
        if (!text.empty()) {
            text += '\n';
        }
        text += describe_table(table);
    }
    return text;
}

std::string describe_table(std::string_view table) {
    if (table == kEventTable) {
        return describe_event_keys();
    }
    std::string text;
    for (const KeyInfo& key : preset_keys()) {
        if (key.table() == table) {
            text += text.empty() ? fmt::format("[{}]\n", table) : "";
            text += describe(key);
            text += describe_conditions(key);
        }
    }
    if (text.empty()) {
        const std::vector<std::string_view> tables = preset_tables();
        const std::string_view meant = nearest(table, tables);
        throw PresetError(
            fmt::format("unknown table [{}]; {}",
                        table,
                        meant.empty() ? fmt::format("must be one of {}", fmt::join(tables, ", "))
                                      : fmt::format("did you mean [{}]?", meant)));
    }
    return text;
}

}  // namespace foam::texgen
