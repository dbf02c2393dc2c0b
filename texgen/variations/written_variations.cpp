// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/written_variations.h"

#include "core/files/file_io.h"
#include "texgen/image/png.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_extension.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/sheet/contact_sheet.h"
#include "texgen/variations/variation_labels.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <system_error>

namespace foam::texgen {

namespace {

/// Returns the path of a file relative to a folder, or its absolute path if it has no relative
/// path.
std::string path_from(const std::filesystem::path& folder, const std::string& file) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    const std::filesystem::path relative = path.lexically_normal().lexically_relative(
        std::filesystem::absolute(folder).lexically_normal());
    return relative.empty() ? path.string() : relative.string();
}

void write_sheet(const VariationSet& set,
                 const std::vector<DrawnVariation>& drawn,
                 const std::filesystem::path& path) {
    std::vector<Thumbnail> thumbnails;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        Thumbnail& thumbnail = thumbnails.emplace_back();
        thumbnail.pixels = drawn[k].pixels;
        thumbnail.labels = picture_labels(set.variations[k]);
        std::string& text = thumbnail.labels.front().text;
        text = fmt::format("{}: {}", k + 1, text);
    }
    // Pictures of at least this width, in pixels, have labels of large letters. At this width, 16
    // large letters fit on a line.
    constexpr int kWide = 200;
    const int magnification = drawn.front().pixels.width() < kWide ? 1 : 2;
    const Image<std::uint8_t> sheet =
        contact_sheet(thumbnails, {.columns = set.columns, .magnification = magnification});
    write_file(
        path,
        encode_png(sheet.view(), {.color = true, .text = {}}, {.compression = Compression::Small}));
}

/// Returns the text of the preset file of a variation. `folder` is the folder of this file. Paths
/// in the text are relative to the folder if possible.
std::string preset_file(const VariationSet& set,
                        const Variation& variation,
                        const std::filesystem::path& folder) {
    std::vector<Assignment> assignments = set.assignments;
    assignments.insert(
        assignments.end(), variation.assignments.begin(), variation.assignments.end());
    locate_files(assignments, [&](const std::string& path) { return path_from(folder, path); });
    return extending_preset(is_preset_path(set.preset) ? path_from(folder, set.preset) : set.preset,
                            assignments);
}

/// Removes the files of an earlier run that this run has not replaced.
void remove_others(const std::vector<std::filesystem::path>& earlier,
                   const std::vector<std::filesystem::path>& written) {
    for (const std::filesystem::path& file : earlier) {
        if (std::ranges::find(written, file) == written.end()) {
            std::error_code error;
            std::filesystem::remove(file, error);
        }
    }
}

}  // namespace

std::vector<std::filesystem::path> WrittenVariations::files() const {
    std::vector<std::filesystem::path> files = {sheet};
    for (const WrittenVariation& one : variations) {
        if (one.preset) {
            files.push_back(*one.preset);
        }
    }
    return files;
}

WrittenVariations write_variations(const VariationSet& set,
                                   const std::vector<DrawnVariation>& drawn,
                                   const VariationFiles& names,
                                   const std::vector<std::filesystem::path>& earlier) {
    WrittenVariations written{.sheet = names.sheet(), .variations = {}};
    const std::filesystem::path folder = written.sheet.parent_path();
    make_folders(folder);
    write_sheet(set, drawn, written.sheet);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        WrittenVariation one{k + 1, set.variations[k], drawn[k].outcome, {}};
        if (one.outcome.status == RunStatus::Complete) {
            one.preset = names.preset(one.number);
            write_variation(*one.preset, preset_file(set, one.variation, folder));
        }
        written.variations.push_back(std::move(one));
    }
    remove_others(earlier, written.files());
    return written;
}

}  // namespace foam::texgen
