// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/program_description.h"

#include "core/parallel/parallel_for.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/profile.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/shipped_presets.h"
#include "texgen/studio/picture.h"
#include "texgen/studio/settings.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace foam::texgen {

namespace {

Json preset_summary(const ShippedPreset& shipped) {
    const Preset preset = load_preset(std::string(shipped.name));
    Json maps = Json::array();
    for (const DrawnImage& image : drawn_images(preset)) {
        maps.push_back(image.name());
    }
    return {{"name", shipped.name},
            {"description", preset.description},
            {"size", {preset.image.width, preset.image.height}},
            {"frames", preset.frames.count},
            {"maps", maps}};
}

Json map_summary(const Map& map) {
    constexpr std::array<std::string_view, 3> kKinds = {"color", "number", "id"};
    return {{"name", map.name},
            {"meaning", map.meaning},
            {"unit", map.unit},
            {"channels", map.channels},
            {"kind", kKinds.at(static_cast<std::size_t>(map.kind))}};
}

}  // namespace

Json describe_program(const StudioFolder& folder) {
    Json presets = Json::array();
    for (const ShippedPreset& shipped : shipped_presets()) {
        presets.push_back(preset_summary(shipped));
    }
    Json maps = Json::array();
    for (const Map& map : all_maps()) {
        maps.push_back(map_summary(map));
    }
    Json profiles = Json::array();
    for (const ShippedProfile& shipped : shipped_profiles()) {
        const Profile profile = load_profile(std::string(shipped.name));
        profiles.push_back({{"name", profile.name}, {"description", profile.description}});
    }
    return {{"version", FOAMTEX_VERSION},
            {"folder", folder.path().string()},
            {"threads", thread_count(0)},
            {"presets", presets},
            {"files", folder.preset_files()},
            {"maps", maps},
            {"profiles", profiles},
            {"schema", Json::parse(preset_schema())},
            {"largest_width", kMaxPictureSide},
            {"largest_foam", kMaxLiveBubbles}};
}

}  // namespace foam::texgen
