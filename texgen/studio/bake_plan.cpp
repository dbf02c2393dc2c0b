// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/bake_plan.h"

#include "texgen/bake/frame_range.h"
#include "texgen/material/profile.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/preset_io.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

std::vector<int> frames_of(const BakeRequest& request, const Preset& preset) {
    if (request.frames) {
        return parse_frame_range(*request.frames);
    }
    std::vector<int> frames(static_cast<std::size_t>(preset.frames.count));
    std::iota(frames.begin(), frames.end(), 1);
    return frames;
}

/// Returns a pattern of file names without the folder "out", in which images are written by
/// default.
std::string without_default_folder(std::string pattern) {
    if (pattern.starts_with(kDefaultFolder)) {
        pattern.erase(0, kDefaultFolder.size());
    }
    return pattern;
}

std::string with_suffix(const std::string& pattern, const std::string& suffix) {
    return std::filesystem::path(pattern).replace_extension(suffix).string();
}

/// Returns the options that the command `bake` needs, in addition to the settings, to bake the
/// images of the request. Paths are relative to the folder of the studio.
std::vector<std::string> options_of(const BakeRequest& request, const Preset& preset) {
    std::vector<std::string> options;
    const auto add = [&](const char* name, const std::string& value) {
        options.insert(options.end(), {name, value});
    };
    if (request.profile) {
        add("--for", *request.profile);
    } else if (!request.maps.empty()) {
        add("--maps", fmt::format("{}", fmt::join(request.maps, ",")));
    }
    if (request.frames) {
        add("--frames", *request.frames);
    }
    if (request.size) {
        const auto [width, height] = *request.size;
        add("--size", fmt::format("{}x{}", width, height));
    }
    add("--out", preset.output.pattern);
    if (preset.output.sheets != SheetKind::None) {
        add("--set", "output.sheet_pattern=" + preset.output.sheet_pattern);
    }
    return options;
}

/// Returns the assignments that the request makes in addition to those of the settings.
std::vector<Assignment> assignments_of(const BakeRequest& request) {
    std::vector<Assignment> assignments;
    if (request.size) {
        const auto [width, height] = *request.size;
        assignments.push_back(
            {"size", "image.size", {Value::List{{std::int64_t{width}}, {std::int64_t{height}}}}});
    }
    if (!request.profile && !request.maps.empty()) {
        Value::List maps;
        for (const std::string& map : request.maps) {
            maps.push_back({map});
        }
        assignments.push_back({"maps", "image.maps", {std::move(maps)}});
    }
    return assignments;
}

/// Replaces the default folder in the file name patterns of a preset by request.folder, or prepends
/// request.folder if a pattern has no default folder. The patterns stay relative to the folder of
/// the studio. Without a profile, images also get the suffix of the requested format. Throws
/// PathRejected if a pattern leaves the folder of the studio.
void place(Preset& preset, const BakeRequest& request, const StudioFolder& folder) {
    const std::filesystem::path base = request.folder;
    const auto below = [&](const std::string& pattern) {
        std::string placed = (base / without_default_folder(pattern)).string();
        folder.below(placed);
        return placed;
    };
    OutputOptions& output = preset.output;
    output.pattern =
        below(request.profile ? output.pattern : with_suffix(output.pattern, request.format));
    output.sheet_pattern = below(output.sheet_pattern);
}

std::array<int, 2> size_in(const JsonValue& value) {
    const std::vector<JsonValue> sides = value.items();
    if (sides.size() != 2) {
        value.reject("a list of a width and a height");
    }
    constexpr int kMax = std::numeric_limits<int>::max();
    return {static_cast<int>(sides[0].integer(1, kMax)),
            static_cast<int>(sides[1].integer(1, kMax))};
}

}  // namespace

BakeRequest read_bake_request(const JsonValue& request) {
    BakeRequest bake{.settings = read_settings(request), .folder = request["folder"].text()};
    if (const auto frames = request.find("frames")) {
        bake.frames = frames->text();
    }
    if (const auto format = request.find("format")) {
        constexpr std::array<std::string_view, 4> kFormats = {"png", "exr", "dds", "ktx2"};
        bake.format = format->word(kFormats);
    }
    if (const auto profile = request.find("profile")) {
        bake.profile = profile->text();
    }
    if (const auto maps = request.find("maps")) {
        for (const JsonValue& map : maps->items()) {
            bake.maps.push_back(map.text());
        }
    }
    if (const auto size = request.find("size")) {
        bake.size = size_in(*size);
    }
    if (const auto resume = request.find("resume")) {
        bake.resume = resume->flag();
    }
    return bake;
}

BakePlan plan_of(const BakeRequest& request, const StudioFolder& folder) {
    PagePreset loaded = load_settings(request.settings, folder);
    BakePlan plan{.preset = std::move(loaded.base)};
    try {
        // The changes of the page come first, then those of the request. All override the profile.
        std::vector<Assignment> overrides = std::move(loaded.resolved_assignments);
        const std::vector<Assignment> requested = assignments_of(request);
        overrides.insert(overrides.end(), requested.begin(), requested.end());
        if (request.profile) {
            // Only shipped profiles are allowed, because a page must not read other files.
            assign(plan.preset,
                   profile_assignments(std::string(find_shipped_profile(*request.profile).name),
                                       plan.preset,
                                       overrides));
        }
        assign(plan.preset, overrides);
    } catch (const PresetError& error) {
        throw SettingsRejected(error.what(), "");
    }
    place(plan.preset, request, folder);
    plan.frames = frames_of(request, plan.preset);
    plan.command = bake_command(request.settings, options_of(request, plan.preset)).value_or("");
    OutputOptions& output = plan.preset.output;
    output.pattern = (folder.path() / output.pattern).string();
    output.sheet_pattern = (folder.path() / output.sheet_pattern).string();
    return plan;
}

}  // namespace foam::texgen
