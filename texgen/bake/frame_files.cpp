// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_files.h"

#include "core/files/file_io.h"
#include "texgen/bake/vector_files.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/primaries.h"
#include "texgen/image/texture_file.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/number_channels.h"
#include "texgen/maps/quantize.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;

/// Returns the metadata texts that all image files of a bake contain, as pairs of a keyword and a
/// text.
Texts texts_of(const Preset& preset) {
    if (preset.output.texts == FileTexts::LeftOut) {
        return {};
    }
    return {{"Title", preset.description},
            {"Software", "foamtex " FOAMTEX_VERSION},
            {"Seed", fmt::format("{}", preset.seeding.seed)},
            {"Preset", to_toml(preset)}};
}

TexelMeaning meaning_of(const MapTraits& traits) {
    if (traits.kind == MapKind::Id) {
        return TexelMeaning::Ids;
    }
    return traits.mixing == Mixing::Slopes ? TexelMeaning::Normals : TexelMeaning::Numbers;
}

EncodingOptions encoding_of(const OutputOptions& output, const DrawnImage& image) {
    const MapTraits& traits = image.traits();
    return {.png = {.filter = traits.png_filter, .compression = output.png_compression},
            .exr = {.compression = output.exr_compression,
                    .zip_level = output.exr_level,
                    .mip_levels = output.exr_layout == ExrLayout::MipLevels},
            .gpu = {.blocks = output.block_compression,
                    .mip_levels = output.mip_levels,
                    .meaning = meaning_of(traits),
                    .used_channels = channel_count(traits)}};
}

ChannelGroup coded(const MapImage& image, int bits) {
    return std::visit([](auto codes) { return code_channels(std::move(codes)); },
                      quantize(image, bits).codes);
}

// Returns the extent of the numbers of an image that is stored as codes (WrittenFile::numbers).
// Only the channels whose map has a key for its range count. Returns nullopt if the pixels are not
// numbers or there is no such channel. `pixels` are the drawn pixels of the image.
std::optional<NumberExtent> extent_in(const DrawnImage& image, const MapImage& pixels) {
    const std::vector<std::size_t> channels = image.ranged_channels();
    const auto* const numbers = std::get_if<NumberPixels>(&pixels);
    return numbers != nullptr && !channels.empty() ? std::optional(extent_of(*numbers, channels))
                                                   : std::nullopt;
}

}  // namespace

bool tiles(const Domain& domain) {
    constexpr double kRounding = 1e-9;  // an event shears in steps, whose strains are rounded
    return !domain.is_plane() &&
           std::abs(std::remainder(domain.shear, domain.width)) <= kRounding * domain.width;
}

FrameFiles::FrameFiles(const Preset& preset)
    : preset_(preset),
      pattern_(preset),
      images_(pattern_.is_vector() ? std::vector<DrawnImage>() : drawn_images(preset)),
      map_names_(pattern_.is_vector() ? std::vector<std::string>() : source_map_names(preset)),
      metadata_{.frame_rate = FrameRate{preset.output.frames_per_second, 1},
                .text = texts_of(preset)} {}

std::filesystem::path FrameFiles::path(std::string_view word, int frame) const {
    return pattern_.path(word, frame);
}

std::vector<std::filesystem::path> FrameFiles::paths(int frame) const {
    std::vector<std::filesystem::path> all;
    for (const std::string& word : file_words(preset_)) {
        all.push_back(path(word, frame));
    }
    if (pattern_.stores_all_maps_in_one_file()) {
        all.resize(1);
    }
    return all;
}

std::vector<WrittenFile> FrameFiles::write_vectors(const SimulatedFrame& shown) const {
    const VectorFormat& format = *vector_format_of(preset_);
    std::vector<WrittenFile> written;
    for (const std::string& part : vector_parts(preset_)) {
        const std::string content = encode_vector(format, shown, preset_, part);
        WrittenFile file{.path = path(part, shown.frame->number),
                         .part = part,
                         .images = {},
                         .bytes = content.size(),
                         .pixels = text_hash(content)};
        make_folders(file.path.parent_path());
        write_file(file.path, std::as_bytes(std::span(content)));
        written.push_back(std::move(file));
    }
    return written;
}

std::vector<WrittenFile> FrameFiles::write(ShownLayers& shown) const {
    if (pattern_.stores_all_maps_in_one_file()) {
        return {write_images(images_, shown)};
    }
    std::vector<WrittenFile> written;
    for (const DrawnImage& image : images_) {
        written.push_back(write_images(std::span(&image, 1), shown));
    }
    return written;
}

DistanceNeeds FrameFiles::needed_distance() const {
    return distance_needs(map_names_, preset_.maps);
}

bool FrameFiles::needs_next() const {
    return !is_vector() && needs_next_frame(preset_);
}

WrittenFile FrameFiles::write_images(std::span<const DrawnImage> images, ShownLayers& shown) const {
    const int frame = shown.layers.frame().number;
    WrittenFile written{};
    written.path = path(file_word(preset_, images.front().name()), frame);
    const Picture picture = picture_of(images, shown, written);
    const EncodingOptions encoding = encoding_of(preset_.output, images.front());
    if (find_texture_format(pattern_.format().suffix) != nullptr) {
        written.images.front().second.pixel_format =
            facts_of(pixel_format_of(picture, encoding.gpu)).name;
    }
    const Bytes stream = pattern_.format().encode(picture, encoding);
    make_folders(written.path.parent_path());
    write_file(written.path, stream);
    written.bytes = stream.size();
    const ImageFormat& format = pattern_.format();
    written.pixels = format.is_lossy ? pixel_hash(format.decode(stream)) : pixel_hash(picture);
    return written;
}

// Returns the picture that a file stores. Sets the members `images`, `numbers` and `displacement`
// of `written`. If the file contains several images, the channels of each image are in a layer with
// the name of the image.
Picture FrameFiles::picture_of(std::span<const DrawnImage> images,
                               ShownLayers& shown,
                               WrittenFile& written) const {
    const ImageFormat& format = pattern_.format();
    const SampleType numbers = preset_.output.exr_numbers;
    Picture picture{{}, metadata_of(images)};
    if (format.samples == FormatSamples::Numbers) {
        picture.metadata.primaries = preset_.output.primaries;
    }
    picture.metadata.periodic = tiles(shown.layers.frame().domain);
    for (const DrawnImage& image : images) {
        const MapTraits& traits = image.traits();
        MapImage pixels = image.draw(shown, preset_.maps);
        written.images.emplace_back(image, describe_samples(image, pixels, format, preset_.output));
        if (!written.displacement) {
            written.displacement = displacement_of(image, shown);
        }
        picture.metadata.color =
            picture.metadata.color || std::holds_alternative<ColorPixels>(pixels);
        if (format.samples == FormatSamples::Codes) {
            written.numbers = extent_in(image, pixels);
            picture.groups.push_back(coded(pixels, code_bits(image, format)));
        } else {
            const ChannelNames names{images.size() > 1 ? traits.name : "", traits.channels};
            const bool is_color = std::holds_alternative<ColorPixels>(pixels);
            picture.groups.push_back(number_channels(std::move(pixels), names, numbers));
            if (is_color) {
                convert_colors(picture, names.layer, Primaries::Srgb, preset_.output.primaries);
            }
        }
    }
    return picture;
}

// Returns a height, as a fraction of the width of the image (WrittenFile::displacement). It is the
// height that the largest code or the number 1 of the image represents. Returns nullopt if the
// image contains no heights.
std::optional<double> FrameFiles::displacement_of(const DrawnImage& image,
                                                  const ShownLayers& shown) const {
    const auto sources = image.sources();
    if (std::ranges::find(sources, kHeightMap.name, &Map::name) == sources.end()) {
        return std::nullopt;
    }
    const bool in_units =
        image.map() != nullptr && pattern_.format().samples == FormatSamples::Numbers;
    return (in_units ? 1.0 : preset_.maps.height.full.value) *
           height_unit(shown.layers, preset_.maps.relief);
}

// Returns the metadata of a file. Unless output.texts leaves texts out, they contain the texts of
// all files (texts_of) and texts about the images of the file. A file of codes states the name and
// the unit of its image, and the range and the note if the image has them. In a file of numbers,
// such as an EXR, the samples are in the unit of their map. Such a file therefore states only the
// notes of its images.
ImageMetadata FrameFiles::metadata_of(std::span<const DrawnImage> images) const {
    ImageMetadata metadata = metadata_;
    if (metadata.text.empty()) {
        return metadata;
    }
    const bool stores_codes = pattern_.format().samples == FormatSamples::Codes;
    for (const DrawnImage& image : images) {
        const MapTraits& traits = image.traits();
        if (stores_codes) {
            metadata.text.emplace_back("Map", traits.name);
            metadata.text.emplace_back("Unit", traits.unit);
            if (image.map() != nullptr && range_option_of(*image.map(), preset_.maps) != nullptr) {
                const AutoReal& range = *range_option_of(*image.map(), preset_.maps);
                metadata.text.emplace_back("Range",
                                           fmt::format("{} = {}", traits.full_key, range.value));
            }
        }
        const std::string note = image.note(preset_.maps);
        if (!note.empty()) {
            metadata.text.emplace_back(stores_codes ? "Note" : fmt::format("Note {}", traits.name),
                                       note);
        }
    }
    return metadata;
}

}  // namespace foam::texgen
