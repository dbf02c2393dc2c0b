// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/settings.h"

#include "texgen/image/shell_word.h"
#include "texgen/material/profile.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/event_io.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_extension.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/preset_remarks.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kMaxSetArguments = 1000;  // largest number of entries of the list `set`

/// Returns the path of the key that an error message concerns. Messages begin with the location of
/// an assignment. The result is empty if no assignment has this location.
std::string key_of(std::string_view message, const std::vector<Assignment>& assignments) {
    const auto found =
        std::find_if(assignments.rbegin(), assignments.rend(), [&](const Assignment& one) {
            return message.starts_with(one.location + ":");
        });
    return found == assignments.rend() ? "" : found->key;
}

std::vector<Assignment> read_events(const std::string& toml) {
    std::vector<Assignment> events = read_assignments(toml, "events");
    for (const Assignment& event : events) {
        if (!is_event_key(event.key)) {
            throw PresetError(fmt::format(
                "{}: key '{}': only [[event]] is allowed here", event.location, event.key));
        }
    }
    return events;
}

/// Returns the events of a preset as a list of objects.
Json events_json(const Preset& preset) {
    Json events = Json::array();
    for (const Assignment& one : read_assignments(events_to_toml(preset), "events")) {
        if (std::holds_alternative<Value::Table>(one.value.data)) {
            events.push_back(Json::object());
        } else {
            events.back()[one.key.substr(one.key.rfind('.') + 1)] = to_json(one.value);
        }
    }
    return events;
}

Json values_json(const Preset& preset) {
    Json values = Json::object();
    for (const Key<Preset>& key : preset_keys()) {
        const std::optional<Value> value = key.write(preset);
        values[key.path] = value ? to_json(*value) : Json(nullptr);
    }
    return values;
}

Json image_names(const Preset& preset) {
    Json names = Json::array();
    for (const DrawnImage& image : drawn_images(preset)) {
        names.push_back(image.name());
    }
    return names;
}

}  // namespace

PageSettings read_settings(const JsonValue& request) {
    const JsonValue given = request["settings"];
    PageSettings settings{.preset = given["preset"].text()};
    for (const JsonValue& set : given["set"].items()) {
        settings.set.push_back(set.text());
        if (settings.set.size() > kMaxSetArguments) {
            given["set"].reject(fmt::format("a list of at most {} texts", kMaxSetArguments));
        }
    }
    if (const auto events = given.find("events")) {
        settings.events = events->text();
    }
    return settings;
}

PagePreset load_settings(const PageSettings& settings, const StudioFolder& folder) {
    PagePreset loaded;
    std::vector<Assignment>& assignments = loaded.assignments;
    try {
        const bool is_file = is_preset_path(settings.preset);
        loaded.base =
            load_preset(is_file ? folder.below(settings.preset).string() : settings.preset);
        for (const std::string& set : settings.set) {
            assignments.push_back(read_set_argument(set));
        }
        if (settings.events) {
            loaded.base.events.clear();
            const std::vector<Assignment> events = read_events(*settings.events);
            assignments.insert(assignments.end(), events.begin(), events.end());
        }
        loaded.resolved_assignments = assignments;
        locate_files(loaded.resolved_assignments,
                     [&](const std::string& path) { return folder.below(path).string(); });
        loaded.preset = loaded.base;
        assign(loaded.preset, loaded.resolved_assignments);
    } catch (const PresetError& error) {
        throw SettingsRejected(error.what(), key_of(error.what(), assignments));
    }
    return loaded;
}

Preset load_live_preset(const PageSettings& settings, const StudioFolder& folder) {
    Preset preset = load_settings(settings, folder).preset;
    if (preset.seeding.bubbles > kMaxLiveBubbles) {
        throw SettingsRejected(
            fmt::format("foam.bubbles = {}: the studio shows foams of at most {} bubbles; larger "
                        "foams can be baked",
                        preset.seeding.bubbles,
                        kMaxLiveBubbles),
            "foam.bubbles");
    }
    return preset;
}

std::optional<std::string> bake_command(const PageSettings& settings,
                                        const std::vector<std::string>& options) {
    if (settings.events) {
        return std::nullopt;
    }
    std::string command = fmt::format("foamtex bake {}", shell_word(settings.preset));
    for (const std::string& set : settings.set) {
        command += fmt::format(" --set {}", shell_word(set));
    }
    for (const std::string& option : options) {
        command += fmt::format(" {}", shell_word(option));
    }
    return command;
}

std::string preset_file(const PageSettings& settings, const PagePreset& loaded) {
    const bool extends = !is_preset_path(settings.preset);
    const bool drops_events = settings.events && loaded.preset.events.empty();
    if (!extends || drops_events) {
        return to_toml(loaded.preset);
    }
    std::string text = extending_preset(settings.preset, loaded.assignments);
    if (settings.events) {
        text += fmt::format("\n{}", events_to_toml(loaded.preset));
    }
    return text;
}

Json describe_settings(const PageSettings& settings, const StudioFolder& folder) {
    const PagePreset loaded = load_settings(settings, folder);
    const Preset& preset = loaded.preset;
    const std::optional<std::string> command = bake_command(settings);
    return {{"name", preset.name},
            {"description", preset.description},
            {"size", {preset.image.width, preset.image.height}},
            {"frames", preset.frames.count},
            {"frames_per_second", preset.output.frames_per_second},
            {"tiles", preset.shape.kind == FoamKind::Torus},
            {"loops", preset.loop.kind != LoopKind::None},
            {"maps", image_names(preset)},
            {"base_color", base_color_map(preset)},
            {"values", values_json(preset)},
            {"events", events_json(preset)},
            {"events_toml", events_to_toml(preset)},
            {"notes", remarks_on(preset, loaded.assignments)},
            {"command", command ? Json(*command) : Json(nullptr)},
            {"toml", preset_file(settings, loaded)},
            {"simulation", simulation_hash(preset)}};
}

}  // namespace foam::texgen
