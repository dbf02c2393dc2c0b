#include "texgen/preset/shipped_presets.h"

#include "texgen/image/file_io.h"
#include "texgen/preset/nearest.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace foam::texgen {

namespace {

bool is_path(std::string_view argument) {
    return argument.ends_with(".toml") || argument.find('/') != std::string_view::npos;
}

Preset load_file(const std::string& path) {
    Bytes content;
    try {
        content = read_file(path);
    } catch (const InputError& error) {
        throw PresetError(error.what());
    }
    const std::string_view toml(reinterpret_cast<const char*>(content.data()), content.size());
    return parse_preset(toml, std::filesystem::path(path).stem().string(), path);
}

std::string unknown_preset(std::string_view name) {
    std::vector<std::string_view> names;
    for (const ShippedPreset& preset : shipped_presets()) {
        names.push_back(preset.name);
    }
    const std::string_view meant = nearest(name, names);
    return fmt::format("preset '{}': must be a .toml file or one of {}{}",
                       name,
                       fmt::join(names, ", "),
                       meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant));
}

}  // namespace

const ShippedPreset& find_shipped_preset(std::string_view name) {
    const auto presets = shipped_presets();
    const auto found = std::find_if(
        presets.begin(), presets.end(), [&](const auto& preset) { return preset.name == name; });
    if (found == presets.end()) {
        throw PresetError(unknown_preset(name));
    }
    return *found;
}

Preset load_preset(const std::string& name_or_path) {
    if (is_path(name_or_path)) {
        return load_file(name_or_path);
    }
    const ShippedPreset& shipped = find_shipped_preset(name_or_path);
    return parse_preset(shipped.toml, name_or_path, "presets/" + name_or_path + ".toml");
}

}  // namespace foam::texgen
