// SPDX-License-Identifier: Apache-2.0

#include "core/library/require.h"
#include "texgen/animation/progress_text.h"
#include "texgen/api/public_errors.h"
#include "texgen/api/state.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/material/scene_files.h"
#include "texgen/preset/preset_io.h"
#include "texgen/sheet/flipbook.h"
#include "texgen/verify/compare_images.h"

#include <foamtex/texture.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace foamtex {

namespace {

using foam::texgen::with_texture_errors;

// Returns the pattern of the files of a bake. If `out` names a folder, this is the preset's own
// pattern, with `out` instead of the folders that all files share. Otherwise it is `out`.
std::string pattern_of(const foam::texgen::Preset& preset, const std::string& out) {
    const std::filesystem::path path(out);
    const bool is_pattern = path.has_extension() || out.find_first_of("{#@%") != std::string::npos;
    std::error_code error;  // is_directory returns false for a path that it cannot examine
    if (is_pattern && !std::filesystem::is_directory(path, error)) {
        return out;
    }
    return (path / foam::texgen::without_shared_folders(preset.output.pattern)).string();
}

foam::texgen::Preset preset_to_bake(const Preset& preset, const std::string& out) {
    foam::texgen::Preset copy = preset.state().preset;
    const foam::texgen::Assignment pattern{
        "out", "output.pattern", foam::texgen::Value{pattern_of(copy, out)}};
    foam::texgen::assign(copy, std::span(&pattern, 1));
    return foam::texgen::with_sheets_beside_images(std::move(copy));
}

foam::texgen::ProgressCallback progress_of(const BakeSettings& settings) {
    if (!settings.on_progress) {
        return {};
    }
    return [&settings](const foam::texgen::RunProgress& progress) {
        settings.on_progress({std::string(foam::texgen::name_of(progress.phase)),
                              progress.done,
                              progress.total,
                              progress.frame});
    };
}

void require_limit(std::string_view name, const std::optional<double>& limit) {
    foam::require(!limit || *limit >= 0.0, name, "at least 0", limit.value_or(0.0));
}

// Throws ArgumentError if a limit is not allowed.
foam::texgen::DifferenceLimits limits_of(const Limits& limits) {
    require_limit("limits.sample", limits.sample);
    require_limit("limits.rms", limits.rms);
    require_limit("limits.angle", limits.angle);
    foam::require_from("limits.allowed_percent", limits.allowed_percent, 0.0, 100.0);
    return {.sample = limits.sample,
            .angle = limits.angle,
            .allowed_percent = limits.allowed_percent,
            .rms = limits.rms};
}

Difference difference_of(const foam::texgen::ComparedImage& image) {
    using foam::texgen::Verdict;
    if (image.verdict == Verdict::Unreadable) {
        throw InputError(image.error);
    }
    const foam::texgen::Comparison& found = image.found;
    Difference difference{.is_within = image.verdict == Verdict::Same,
                          .map = image.map,
                          .layer = image.layer,
                          .largest = found.largest,
                          .mean = found.mean,
                          .rms = found.rms,
                          .channel = found.channel,
                          .x = found.x,
                          .y = found.y,
                          .reasons = found.reasons};
    difference.same_shape = image.verdict != Verdict::DifferentLayout;
    if (!difference.same_shape) {
        difference.reasons.emplace_back("the images differ in size or channels");
    }
    return difference;
}

}  // namespace

std::vector<std::string> bake(const Preset& preset,
                              const std::string& out,
                              const BakeSettings& settings) {
    return with_texture_errors([&] {
        foam::require_threads(settings.threads);
        const foam::texgen::Preset baked = preset_to_bake(preset, out);
        foam::texgen::check_scenes(baked);
        foam::texgen::check_sheets(baked);
        foam::texgen::check_sheet_folder(baked);
        const foam::texgen::BakeOptions options{
            .frames = foam::texgen::frames_or_all(settings.frames, baked.frames.count),
            .threads = settings.threads};
        const foam::texgen::ProgressCallback on_progress = progress_of(settings);
        const foam::texgen::BakeSummary summary = foam::texgen::bake_recorded(
            baked,
            options,
            {.on_progress = on_progress},
            {.resume = settings.resume ? foam::texgen::Resume::Yes : foam::texgen::Resume::No});
        foam::texgen::throw_if_failed(summary.outcome);
        if (baked.output.sheets != foam::texgen::SheetKind::None) {
            foam::texgen::write_sheets(baked, options.frames, on_progress);
        }
        if (!baked.output.scene.empty()) {
            foam::texgen::write_scenes(baked);
        }
        std::vector<std::string> names;
        for (const std::filesystem::path& file : summary.files) {
            names.push_back(file.string());
        }
        return names;
    });
}

std::vector<Difference> compare(const std::string& a,
                                const std::string& b,
                                const Limits& limits,
                                const std::string& picture) {
    return with_texture_errors([&] {
        const foam::texgen::DifferenceLimits given = limits_of(limits);
        foam::texgen::CompareOptions options{.limits_of = [&](std::string_view) {
            return foam::texgen::CompareLimits{.warn = given, .fail = given};
        }};
        if (!picture.empty()) {
            options.difference = picture;
        }
        std::vector<Difference> differences;
        for (const foam::texgen::ComparedImage& image :
             foam::texgen::compare_pair({.a = a, .b = b}, options)) {
            differences.push_back(difference_of(image));
        }
        return differences;
    });
}

}  // namespace foamtex
