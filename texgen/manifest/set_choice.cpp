// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/set_choice.h"

#include "core/files/file_io.h"
#include "texgen/keys/nearest.h"
#include "texgen/manifest/manifest_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace foam::texgen {

namespace {

template <class Value>
bool is_selected(const std::optional<Value>& chosen, const Value& value) {
    return !chosen || *chosen == value;
}

bool selects(const SetChoice& choice, const BakedSet& set) {
    return (choice.preset.empty() || choice.preset == set.preset) &&
           is_selected(choice.seed, set.seed) && is_selected(choice.width, set.width) &&
           is_selected(choice.height, set.height);
}

// Returns a choice in words, such as "preset 'lava', seed 6".
std::string words_of(const SetChoice& choice) {
    std::vector<std::string> words;
    if (!choice.preset.empty()) {
        words.push_back(fmt::format("preset '{}'", choice.preset));
    }
    if (choice.seed) {
        words.push_back(fmt::format("seed {}", *choice.seed));
    }
    if (choice.width) {
        words.push_back(fmt::format("width {}", *choice.width));
    }
    if (choice.height) {
        words.push_back(fmt::format("height {}", *choice.height));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

// Returns the end of a message about an unknown preset, which suggests the preset of the manifest
// with the most similar name. Returns an empty text if the manifest has the preset, or if no preset
// of the manifest has a similar name.
std::string similar_preset(const Manifest& manifest, const std::string& preset) {
    std::vector<std::string_view> presets;
    for (const BakedSet& set : manifest.sets) {
        presets.emplace_back(set.preset);
    }
    return std::ranges::find(presets, preset) == presets.end() ? did_you_mean(preset, presets) : "";
}

}  // namespace

std::string name_of(const BakedSet& set) {
    return fmt::format("{} (seed {}, {} x {})", set.preset, set.seed, set.width, set.height);
}

std::vector<const BakedSet*> selected_sets(const Manifest& manifest, const SetChoice& choice) {
    std::vector<const BakedSet*> selected;
    for (const BakedSet& set : manifest.sets) {
        if (selects(choice, set)) {
            selected.push_back(&set);
        }
    }
    return selected;
}

const BakedSet& newest_set(const Manifest& manifest,
                           const SetChoice& choice,
                           const std::filesystem::path& path) {
    if (manifest.sets.empty()) {
        throw InputError(fmt::format("'{}' lists no images", manifest_path(path).string()));
    }
    const std::vector<const BakedSet*> selected = selected_sets(manifest, choice);
    if (selected.empty()) {
        std::vector<std::string> names;
        for (const BakedSet& set : manifest.sets) {
            names.push_back(name_of(set));
        }
        throw InputError(fmt::format("'{}' has no images of {}; it has images of: {}{}",
                                     manifest_path(path).string(),
                                     words_of(choice),
                                     fmt::join(names, ", "),
                                     similar_preset(manifest, choice.preset)));
    }
    return *selected.back();
}

}  // namespace foam::texgen
