#include "texgen/preset/preset_io.h"

#include "texgen/preset/event_io.h"
#include "texgen/preset/loop_schema.h"
#include "texgen/preset/map_schema.h"
#include "texgen/preset/nearest.h"
#include "texgen/preset/refusal.h"
#include "texgen/preset/schema.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kLargestAspect = 16;

/// The known key or table that comes nearest, also where only its table was forgotten.
std::string_view suggestion(const std::string& path) {
    std::vector<std::string_view> paths;
    std::vector<std::string_view> names;
    for (const Key& key : preset_keys()) {
        paths.push_back(key.path);
        names.push_back(key.name());
    }
    const std::string_view name = std::string_view(path).substr(path.rfind('.') + 1);
    const auto same_name = std::find(names.begin(), names.end(), name);
    if (same_name != names.end()) {
        return paths[static_cast<std::size_t>(same_name - names.begin())];
    }
    return nearest(path, paths);
}

void assign_one(Preset& preset, const Assignment& assignment) {
    if (is_event_key(assignment.key)) {
        assign_event(preset, assignment);
        return;
    }
    const Key* key = find_key(assignment.key);
    const bool table = std::holds_alternative<Value::Table>(assignment.value.data);
    if (key == nullptr && table && is_table(assignment.key)) {
        return;
    }
    if (key == nullptr) {
        refuse_unknown(assignment, suggestion(assignment.key));
    }
    if (!key->read(assignment.value, preset)) {
        refuse(assignment, "must be " + key->allowed);
    }
}

/// Of the assignments to one of two keys the last; to the first key, if there is any.
const Assignment& blamed(std::span<const Assignment> assignments,
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

/// What would have no effect must not be asked for.
void check_kind(const Preset& preset, std::span<const Assignment> assignments) {
    const Preset defaults;
    for (const Key& key : preset_keys()) {
        if (key.kind.value_or(preset.shape.kind) != preset.shape.kind &&
            to_toml(key.write(preset)) != to_toml(key.write(defaults))) {
            refuse(
                blamed(assignments, key.path, "foam.domain"),
                fmt::format("{} is only for foam.domain = \"{}\"", key.path, name_of(*key.kind)));
        }
    }
}

/// A foam of few bubbles does not fit a torus that is much longer than wide.
void check_aspect(const Preset& preset, std::span<const Assignment> assignments) {
    const int shorter = std::min(preset.image.width, preset.image.height);
    const int longer = std::max(preset.image.width, preset.image.height);
    if (longer > kLargestAspect * shorter) {
        refuse_last(assignments,
                    {"image.size"},
                    fmt::format("one side must be at most {} times the other", kLargestAspect));
    }
}

}  // namespace

void assign(Preset& preset, std::span<const Assignment> assignments) {
    for (const Assignment& assignment : assignments) {
        assign_one(preset, assignment);
    }
    check_kind(preset, assignments);
    check_maps(preset, assignments);
    check_aspect(preset, assignments);
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
    for (const Key& key : preset_keys()) {
        if (key.table() != table) {
            table = key.table();
            toml += fmt::format("{}[{}]\n", toml.empty() ? "" : "\n", table);
        }
        toml += fmt::format("{} = {}\n", key.name(), to_toml(key.write(preset)));
    }
    return toml + events_to_toml(preset);
}

std::string describe_keys() {
    std::string text;
    std::string_view table;
    const Preset defaults;
    for (const Key& key : preset_keys()) {
        if (key.table() != table) {
            table = key.table();
            text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", table);
        }
        text += fmt::format("{} = {}\n", key.name(), to_toml(key.write(defaults)));
        text += fmt::format("    {}\n    {}\n", key.meaning, key.allowed);
        text += key.kind ? fmt::format("    of a {}\n", name_of(*key.kind)) : "";
    }
    return text + describe_event_keys();
}

}  // namespace foam::texgen
