// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/baked_sets.h"

#include "core/files/file_io.h"
#include "texgen/image/color.h"
#include "texgen/image/picture.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_frame.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/studio/samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

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
                           {"set", set.parameters},
                           {"preset", set.preset},
                           {"size", {set.width, set.height}},
                           {"frames", set.frames()},
                           {"frames_per_second", set.frames_per_second},
                           {"maps", maps}});
        }
    } catch (const InputError&) {
        // A folder with a damaged manifest is not offered.
    } catch (const PathRejected&) {
        // A folder is not offered either if requests for its images would be rejected.
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

/// Returns the description and the file of an image. Throws PathRejected if the file is a link that
/// leads out of the folder of the studio.
MapSequence sequence_of(const StudioFolder& folder, const BakedImage& image) {
    const std::filesystem::path path = folder.below(image.folder);
    const Manifest manifest = read_manifest(path);
    const auto set = std::ranges::find(manifest.sets, image.set, &BakedSet::parameters);
    if (set == manifest.sets.end()) {
        throw std::invalid_argument(
            "there is no such set of images; refresh the list of baked sets");
    }
    MapSequence sequence = map_sequence(*set, path, image.map, std::span(&image.frame, 1));
    folder.below(sequence.files.front().path.lexically_relative(folder.path()).string());
    if (!sequence.map.samples) {
        throw std::invalid_argument(fmt::format("'{}' is not an image", image.map));
    }
    return sequence;
}

/// Returns the index of the pixel at a fraction of the width or the height of an image.
int pixel_at(double fraction, int count) {
    return std::min(static_cast<int>(std::clamp(fraction, 0.0, 1.0) * count), count - 1);
}

/// Returns the channels of a map in its file, in the order of MapSamples::channels. In files of
/// codes (integer samples) the channels have the names that code_channel_names returns, such as R,
/// G and B, whatever their names in the map. Padding channels, which have the name 0, are left out.
std::vector<PictureChannel> channels_of_map(const Picture& picture, const MapSamples& samples) {
    const std::vector<PictureChannel> all = channels_of(picture);
    const ChannelGroup& group = picture.groups.front();
    std::string names = samples.channels;
    std::erase(names, ' ');
    const std::string in_file(group.has_codes() ? code_channel_names(group.channels()) : names);
    std::vector<PictureChannel> found;
    for (std::size_t k = 0; k < std::min(names.size(), in_file.size()); ++k) {
        const auto channel =
            std::ranges::find(all, std::string_view(in_file).substr(k, 1), &PictureChannel::name);
        if (names[k] != '0' && channel != all.end()) {
            found.push_back(*channel);
        }
    }
    return found;
}

/// The function read_numbers scales codes so that the largest code becomes 1. This function returns
/// the two numbers, in the unit of the map, that 0 and 1 then stand for. Samples that are not codes
/// are not scaled, and the two numbers are 0 and 1.
std::array<double, 2> range_of(const MapSamples& samples, const ChannelGroup& group) {
    if (!group.has_codes()) {
        return {0.0, 1.0};
    }
    const double largest_code = group.type == SampleType::Uint8 ? 255.0 : 65535.0;
    return samples.range.value_or(std::array{0.0, samples.kind == "id" ? largest_code : 1.0});
}

/// Returns the samples of a pixel of a file, in the unit of the map.
Json numbers_at(const Picture& picture, const MapSamples& samples, double x, double y) {
    const auto column = static_cast<std::size_t>(pixel_at(x, picture.width()));
    const int row = picture.height() - 1 - pixel_at(y, picture.height());
    const auto [low, high] = range_of(samples, picture.groups.front());
    std::vector<double> numbers(static_cast<std::size_t>(picture.width()));
    Json all = Json::array();
    for (const PictureChannel& channel : channels_of_map(picture, samples)) {
        read_numbers(channel, row, numbers);
        all.push_back(number_or_null(low + numbers[column] * (high - low)));
    }
    return all;
}

/// Returns the color of a pixel as "#rrggbb" (sRGB).
std::string color_at(const DisplayFrame& frame, double x, double y) {
    const int column = pixel_at(x, frame.pixels.width());
    const int row = frame.pixels.height() - 1 - pixel_at(y, frame.pixels.height());
    DisplayFrame pixel{Image<float>(1, 1, DisplayFrame::kColors), frame.is_light};
    std::ranges::copy(frame.pixels.pixel(column, row), pixel.pixels.samples().begin());
    const Image<std::uint8_t> code = codes_of(pixel);
    return color_text({code.samples()[0], code.samples()[1], code.samples()[2]});
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
    return picture_of(sequence_of(folder, image), side);
}

Json pick_baked(const StudioFolder& folder, const BakedImage& image, double x, double y) {
    const auto& [map, files] = sequence_of(folder, image);
    Json picked = {
        {"numbers", Json::array()}, {"unit", map.unit}, {"color", nullptr}, {"bubble", nullptr}};
    if (map.samples->kind == "color") {
        picked["color"] = color_at(read_display_frame(files.front(), map), x, y);
    } else {
        picked["numbers"] = numbers_at(read_map_frame(files.front(), map.name), *map.samples, x, y);
    }
    return picked;
}

}  // namespace foam::texgen
