// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_files.h"

#include "texgen/image/file_io.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/maps/number_channels.h"
#include "texgen/maps/quantize.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;

/// Returns the metadata texts that all files of a bake contain, as pairs of a keyword and a text.
Texts texts_of(const Preset& preset) {
    if (preset.output.texts == FileTexts::LeftOut) {
        return {};
    }
    return {{"Title", preset.description},
            {"Software", "foamtex " FOAMTEX_VERSION},
            {"Seed", fmt::format("{}", preset.seeding.seed)},
            {"Preset", to_toml(preset)}};
}

std::vector<const Map*> maps_of(const Preset& preset) {
    std::vector<const Map*> maps;
    for (const std::string& name : preset.image.maps) {
        maps.push_back(&find_map(name));
    }
    return maps;
}

EncodingOptions encoding_of(const OutputOptions& output, const Map& map) {
    return {.png = {.filter = map.png_filter, .compression = output.png_compression},
            .exr = {.compression = output.exr_compression,
                    .zip_level = output.exr_level,
                    .mip_levels = output.exr_layout == ExrLayout::MipLevels}};
}

ChannelGroup coded(const MapImage& image, int bits) {
    return std::visit([](auto codes) { return code_channels(std::move(codes)); },
                      quantize(image, bits).codes);
}

}  // namespace

bool tiles(const Domain& domain) {
    return !domain.is_plane() && domain.shear == 0.0;
}

FrameFiles::FrameFiles(const Preset& preset)
    : preset_(preset),
      pattern_(preset.output.pattern),
      maps_(maps_of(preset)),
      metadata_{.frame_rate = FrameRate{preset.output.frames_per_second, 1},
                .text = texts_of(preset)} {}

std::filesystem::path FrameFiles::path(const Map& map, int frame) const {
    return pattern_.path(preset_.name, map.name, frame);
}

std::vector<std::filesystem::path> FrameFiles::paths(int frame) const {
    std::vector<std::filesystem::path> all;
    for (const Map* map : maps_) {
        all.push_back(path(*map, frame));
    }
    if (pattern_.stores_all_maps_in_one_file()) {
        all.resize(1);
    }
    return all;
}

std::vector<WrittenFile> FrameFiles::write(ShownLayers& shown) const {
    if (pattern_.stores_all_maps_in_one_file()) {
        return {write_maps(maps_, shown)};
    }
    std::vector<WrittenFile> written;
    for (const Map* const map : maps_) {
        written.push_back(write_maps(std::span(&map, 1), shown));
    }
    return written;
}

DistanceNeeds FrameFiles::distance() const {
    return distance_needs(preset_.image.maps, preset_.maps);
}

bool FrameFiles::needs_next() const {
    return std::any_of(maps_.begin(), maps_.end(), [](const Map* map) { return map->needs_next; });
}

WrittenFile FrameFiles::write_maps(std::span<const Map* const> maps, ShownLayers& shown) const {
    const int frame = shown.layers.frame().number;
    WrittenFile written{};
    written.path = path(*maps.front(), frame);
    const Picture picture = picture_of(maps, shown, written);
    const Bytes stream =
        pattern_.format().encode(picture, encoding_of(preset_.output, *maps.front()));
    make_folders(written.path.parent_path());
    write_file(written.path, stream);
    written.bytes = stream.size();
    written.pixels = pixel_hash(picture);
    return written;
}

// Returns the picture of a file and adds a description of each map to `written`. For a file of
// codes (integer samples, such as a PNG), also stores in `written` the extent of the numbers, if
// the map has a key for its range, and the displacement, if the map is `height`. If the file
// contains several maps, the channels of each map are in a layer with the name of the map.
Picture FrameFiles::picture_of(std::span<const Map* const> maps,
                               ShownLayers& shown,
                               WrittenFile& written) const {
    const ImageFormat& format = pattern_.format();
    const SampleType numbers = preset_.output.exr_numbers;
    Picture picture{{}, metadata_of(maps)};
    picture.metadata.periodic = tiles(shown.layers.frame().domain);
    for (const Map* const map : maps) {
        MapImage image = draw(*map, shown, preset_.maps);
        written.maps.emplace_back(map, describe_samples(*map, image, format, numbers));
        picture.metadata.color =
            picture.metadata.color || std::holds_alternative<ColorPixels>(image);
        if (format.samples == FormatSamples::Codes) {
            if (!map->full_key.empty()) {
                written.numbers = extent_of(std::get<NumberPixels>(image));
            }
            if (map->name == kHeightMap.name) {
                written.displacement =
                    preset_.maps.height.full.value * height_unit(shown.layers, preset_.maps.relief);
            }
            picture.groups.push_back(coded(image, code_bits(*map, format)));
        } else {
            const ChannelNames names{maps.size() > 1 ? map->name : "", map->channels};
            picture.groups.push_back(number_channels(std::move(image), names, numbers));
        }
    }
    return picture;
}

// Returns the metadata of a file. Unless output.texts leaves texts out, a file of codes contains,
// besides the texts of all files (texts_of), the name and the unit of its map, and the range and
// the note if the map has them. In a file of numbers, such as an EXR, the samples are in the unit
// of their map, so only the notes of its maps are added.
ImageMetadata FrameFiles::metadata_of(std::span<const Map* const> maps) const {
    ImageMetadata metadata = metadata_;
    if (metadata.text.empty()) {
        return metadata;
    }
    const bool codes = pattern_.format().samples == FormatSamples::Codes;
    for (const Map* const map : maps) {
        if (codes) {
            metadata.text.emplace_back("Map", map->name);
            metadata.text.emplace_back("Unit", map->unit);
            if (const AutoReal* const full = range_option_of(*map, preset_.maps)) {
                metadata.text.emplace_back("Range",
                                           fmt::format("{} = {}", map->full_key, full->value));
            }
        }
        if (map->note != nullptr) {
            metadata.text.emplace_back(codes ? "Note" : fmt::format("Note {}", map->name),
                                       map->note(preset_.maps));
        }
    }
    return metadata;
}

}  // namespace foam::texgen
