// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/baked_sets.h"

#include "core/files/file_io.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/studio/samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// Adds the sets of a manifest, whose path is relative to the folder of the studio.
void add_sets(const StudioFolder& studio, const std::filesystem::path& manifest, Json& all) {
    const std::string folder = manifest.parent_path().string();
    try {
        for (const BakedSet& set : read_manifest(studio.below(folder)).sets) {
            Json maps = Json::array();
            for (const ManifestMap& map : set.maps) {
                maps.push_back(
                    {{"name", map.name}, {"kind", map.samples ? map.samples->kind : ""}});
            }
            all.push_back({{"folder", folder},
                           {"preset", set.preset},
                           {"size", {set.width, set.height}},
                           {"frames", set.frames()},
                           {"frames_per_second", set.frames_per_second},
                           {"maps", maps}});
        }
    } catch (const InputError&) {
        // A folder with a damaged manifest is not offered.
    }
}

HttpResponse picture_of(const MapSequence& sequence, int side) {
    DisplayFrame frame = read_display_frame(sequence.files.front(), sequence.map);
    const int width = frame.pixels.width();
    const int height = frame.pixels.height();
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(width, height));
    if (scale < 1.0) {
        frame = reduced(frame,
                        std::max(1, static_cast<int>(width * scale)),
                        std::max(1, static_cast<int>(height * scale)));
    }
    const Image<std::uint8_t> codes = codes_of(frame);
    const Json header = {{"width", codes.width()},
                         {"height", codes.height()},
                         {"channels", 4},
                         {"frame", sequence.files.front().frame},
                         {"exact", scale == 1.0},
                         {"low", nullptr},
                         {"high", nullptr}};
    return {.content_type = "application/octet-stream",
            .headers = {{"X-Foamtex-Picture", json_text(header)}},
            .body = rgba_from_top(codes)};
}

}  // namespace

Json describe_baked_sets(const StudioFolder& folder) {
    Json all = Json::array();
    for (const std::filesystem::path& manifest : folder.bakes()) {
        add_sets(folder, manifest, all);
    }
    return {{"bakes", all}};
}

HttpResponse baked_picture(const StudioFolder& folder, const BakedImage& image, int side) {
    const std::filesystem::path path = folder.below(image.folder);
    const Manifest manifest = read_manifest(path);
    const auto set = std::ranges::find(manifest.sets, image.preset, &BakedSet::preset);
    if (set == manifest.sets.end()) {
        throw std::invalid_argument(fmt::format("no images of '{}' were baked", image.preset));
    }
    const MapSequence sequence = map_sequence(*set, path, image.map, std::span(&image.frame, 1));
    // The file of the image must not be a link that leaves the folder.
    folder.below(sequence.files.front().path.lexically_relative(folder.path()).string());
    return picture_of(sequence, side);
}

}  // namespace foam::texgen
