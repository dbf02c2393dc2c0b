// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/load_preset.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/preset/event_io.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/rejection.h"
#include "texgen/preset/shipped_presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::string_view kExtends = "extends";

// The TOML text of a preset and its origin.
struct Document {
    std::string reference;  // the name of a shipped preset, or the path of a file (is_preset_path)
    std::string name;       // the name of the preset
    std::string source;     // the name of the document in error messages
    std::string toml;
    std::filesystem::path folder;  // relative paths in the text are relative to this folder
};

Document read_document(const std::string& path) {
    try {
        std::string name = std::filesystem::path(path).stem().string();
        if (!is_plain_name(name)) {
            throw PresetError(fmt::format(
                "'{}': the name of a preset must be UTF-8 without control characters, must not "
                "begin with '.', and must have at most 200 bytes",
                path));
        }
        const Bytes content = read_file(path, kPresetInput);
        return {path,
                std::move(name),
                path,
                std::string(as_text(content)),
                std::filesystem::path(path).parent_path()};
    } catch (const InputError& error) {
        throw PresetError(error.what());
    }
}

Document find_document(const std::string& name_or_path) {
    if (is_preset_path(name_or_path)) {
        return read_document(name_or_path);
    }
    const ShippedPreset& shipped = find_shipped_preset(name_or_path);
    return {name_or_path,
            name_or_path,
            fmt::format("presets/{}.toml", name_or_path),
            std::string(shipped.toml),
            {}};
}

// Returns the assignments of a document. Relative paths in a document are relative to its folder;
// in the result, they are relative to the working folder.
std::vector<Assignment> assignments_of(const Document& document) {
    std::vector<Assignment> assignments = read_assignments(document.toml, document.source);
    locate_files(assignments, [&](const std::string& path) {
        return (document.folder / path).lexically_normal().string();
    });
    return assignments;
}

// Loads a preset and the presets that it extends, directly or indirectly.
class Loader {
  public:
    LoadedPreset load(const Document& document) {
        loaded_.push_back(document.reference);
        std::vector<Assignment> assignments = assignments_of(document);
        Preset preset = take_extended(assignments, document);
        preset.name = document.name;
        // The events of a preset replace all events of the preset that it extends.
        if (std::any_of(assignments.begin(), assignments.end(), [](const Assignment& one) {
                return is_event_key(one.key);
            })) {
            preset.events.clear();
        }
        assign(preset, assignments);
        return {std::move(preset), std::move(assignments)};
    }

  private:
    // If there is an assignment to `extends`, removes it from the assignments and returns the
    // preset that it names. Otherwise returns the default preset.
    Preset take_extended(std::vector<Assignment>& assignments, const Document& document) {
        const auto found = std::find_if(assignments.begin(),
                                        assignments.end(),
                                        [](const Assignment& one) { return one.key == kExtends; });
        if (found == assignments.end()) {
            return {};
        }
        const Assignment extends = *found;
        assignments.erase(found);
        const auto* name = std::get_if<std::string>(&extends.value.data);
        if (name == nullptr) {
            reject(extends, "must be the name of a preset or a .toml file, in quotes");
        }
        const Document other = find_extended(*name, extends, document);
        if (std::find(loaded_.begin(), loaded_.end(), other.reference) != loaded_.end()) {
            reject(extends,
                   fmt::format(
                       "circular extends: {} -> {}", fmt::join(loaded_, " -> "), other.reference));
        }
        return load(other).preset;
    }

    static Document find_extended(const std::string& name,
                                  const Assignment& extends,
                                  const Document& document) {
        try {
            return find_document(
                is_preset_path(name) ? (document.folder / name).lexically_normal().string() : name);
        } catch (const PresetError& error) {
            reject(extends, error.what());
        }
    }

    // The references of the documents loaded so far; each document extends the next one.
    std::vector<std::string> loaded_;
};

}  // namespace

bool is_preset_path(std::string_view name_or_path) {
    return name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string_view::npos;
}

LoadedPreset load_with_assignments(const std::string& name_or_path) {
    return Loader().load(find_document(name_or_path));
}

Preset load_preset(const std::string& name_or_path) {
    return load_with_assignments(name_or_path).preset;
}

}  // namespace foam::texgen
