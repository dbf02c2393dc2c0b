// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/profile.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/rejection.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::string_view kTable = "profile";
constexpr std::string_view kDescription = "profile.description";

// Returns the first part of a key, such as "image" for "image.maps".
std::string_view table_of(std::string_view key) {
    return key.substr(0, key.find_first_of(".["));
}

std::string text_in(const std::string& path) {
    try {
        const Bytes content = read_file(path, kPresetInput);
        return std::string(as_text(content));
    } catch (const InputError& error) {
        throw PresetError(error.what());
    }
}

// Replaces a word wherever no other letter, digit or '_' directly precedes or follows it.
std::string with_word(std::string text, std::string_view word, std::string_view replacement) {
    const auto is_word_character = [&](std::size_t k) {
        return k < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
    };
    for (std::size_t k = text.find(word); k != std::string::npos; k = text.find(word, k)) {
        const bool is_whole =
            (k == 0 || !is_word_character(k - 1)) && !is_word_character(k + word.size());
        if (is_whole) {
            text.replace(k, word.size(), replacement);
        }
        k += is_whole ? replacement.size() : word.size();
    }
    return text;
}

// Replaces the name of the map albedo by `base` in an item of a list, but only where the item names
// a map. This is everywhere in image.maps, after the "=" in output.pack ("NAME=R,G,B"), and before
// the "=" in output.names ("MAP=WORD").
std::string with_base_color(const std::string& key,
                            const std::string& item,
                            const std::string& base) {
    const std::size_t equals = std::min(item.find('='), item.size());
    const std::string before = item.substr(0, equals);
    const std::string rest = item.substr(equals);
    if (key == "output.pack") {
        return before + with_word(rest, kAlbedoMap.name, base);
    }
    return (before == kAlbedoMap.name ? base : before) + rest;
}

// Returns the texts of a value that is a list of texts or a single text. Other items are left out.
std::vector<std::string> texts_in(const Value& value) {
    const auto* const list = std::get_if<Value::List>(&value.data);
    std::vector<std::string> texts;
    for (const Value& item : list != nullptr ? *list : Value::List{value}) {
        if (const auto* const text = std::get_if<std::string>(&item.data)) {
            texts.push_back(*text);
        }
    }
    return texts;
}

Value list_of(const std::vector<std::string>& texts) {
    Value::List list;
    for (const std::string& text : texts) {
        list.push_back({text});
    }
    return {std::move(list)};
}

// Returns true if the value of image.maps in a profile contains a map.
bool lists_map(const Profile& profile, const std::string& map) {
    return std::ranges::any_of(profile.assignments, [&](const Assignment& assignment) {
        const std::vector<std::string> maps = texts_in(assignment.value);
        return assignment.key == "image.maps" && std::ranges::find(maps, map) != maps.end();
    });
}

std::string lit_color_map(LitColors colors) {
    switch (colors) {
        case LitColors::ThinFilm:
            return std::string(kThinFilmMap.name);
        case LitColors::Maze:
            return std::string(kMazeMap.name);
        case LitColors::Albedo:
            break;
    }
    return std::string(kAlbedoMap.name);
}

}  // namespace

Profile parse_profile(std::string_view toml, std::string name, const std::string& source) {
    Profile profile{.name = std::move(name), .description = {}, .assignments = {}};
    for (Assignment& assignment : read_assignments(toml, source)) {
        const std::string_view table = table_of(assignment.key);
        if (assignment.key == kDescription) {
            const auto* const text = std::get_if<std::string>(&assignment.value.data);
            if (text == nullptr) {
                reject(assignment, "must be a text in quotes");
            }
            profile.description = *text;
        } else if (table == kTable && assignment.key != kTable) {
            reject(assignment, "unknown key; the only key of the table [profile] is 'description'");
        } else if (table != kTable && table_affects_simulation(table)) {
            reject(
                assignment,
                "a profile can only set keys of the maps and of the tables preset, image, camera, "
                "output, vector and mesh");
        } else if (table != kTable) {
            profile.assignments.push_back(std::move(assignment));
        }
    }
    return profile;
}

Profile load_profile(const std::string& name_or_path) {
    if (!is_preset_path(name_or_path)) {
        const ShippedProfile& shipped = find_shipped_profile(name_or_path);
        return parse_profile(
            shipped.toml, name_or_path, fmt::format("presets/profiles/{}.toml", name_or_path));
    }
    return parse_profile(
        text_in(name_or_path), std::filesystem::path(name_or_path).stem().string(), name_or_path);
}

std::vector<Assignment> assignments_for(const Profile& profile, const Preset& preset) {
    std::string base = base_color_map(preset);
    if (lists_map(profile, base) && lists_map(profile, std::string(kAlbedoMap.name))) {
        base = kAlbedoMap.name;  // so that nothing is replaced
    }
    std::vector<Assignment> assignments = profile.assignments;
    for (Assignment& assignment : assignments) {
        const bool names_maps = assignment.key == "image.maps" || assignment.key == "output.pack" ||
                                assignment.key == "output.names";
        if (!names_maps) {
            continue;
        }
        std::vector<std::string> texts = texts_in(assignment.value);
        for (std::string& text : texts) {
            text = with_base_color(assignment.key, text, base);
        }
        if (assignment.key == "image.maps" && preset.maps.lit.glow == 0.0) {
            std::erase(texts, kEmissionMap.name);
        }
        assignment.value = list_of(texts);
    }
    return assignments;
}

std::vector<Assignment> profile_assignments(const std::string& profile,
                                            const Preset& preset,
                                            std::span<const Assignment> overrides) {
    Preset changed = preset;
    assign(changed, overrides);
    changed.image.maps = preset.image.maps;
    return assignments_for(load_profile(profile), changed);
}

std::string base_color_map(const Preset& preset) {
    for (const std::string& name : preset.image.maps) {
        if (name == kLitMap.name) {
            return lit_color_map(preset.maps.lit.colors);
        }
        const bool is_special = name == kEmissionMap.name || name == kIdColorMap.name;
        if (find_map(name).kind == MapKind::Color && !is_special) {
            return name;
        }
    }
    return std::string(kAlbedoMap.name);
}

}  // namespace foam::texgen
