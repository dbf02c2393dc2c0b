#include "texgen/bake/frame_files.h"

#include "texgen/image/file_io.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/maps/exr_layers.h"
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

// What every file of a bake says about itself.
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

}  // namespace

bool tiles(const Domain& domain) {
    return !domain.is_plane() && domain.shear == 0.0;
}

FrameFiles::FrameFiles(const Preset& preset)
    : preset_(preset),
      pattern_(preset.output.pattern),
      maps_(maps_of(preset)),
      png_{.color = false, .text = texts_of(preset)},
      exr_{.frame_rate = FrameRate{preset.output.frames_per_second, 1}, .text = png_.text} {}

std::filesystem::path FrameFiles::path(const Map& map, int frame) const {
    return pattern_.path(preset_.name, map.name, frame);
}

std::vector<std::filesystem::path> FrameFiles::paths(int frame) const {
    std::vector<std::filesystem::path> all;
    for (const Map* map : maps_) {
        all.push_back(path(*map, frame));
    }
    if (pattern_.joins_maps()) {
        all.resize(1);
    }
    return all;
}

std::vector<WrittenFile> FrameFiles::write(ShownLayers& shown) {
    const int frame = shown.layers.frame().number;
    if (pattern_.joins_maps()) {
        return {write_exr(maps_, shown, path(*maps_.front(), frame))};
    }
    std::vector<WrittenFile> written;
    for (const Map* map : maps_) {
        if (pattern_.format() == FileFormat::Exr) {
            written.push_back(write_exr(std::span(&map, 1), shown, path(*map, frame)));
        } else {
            written.push_back(write_png(*map, draw(*map, shown, preset_.maps), path(*map, frame)));
        }
    }
    return written;
}

DistanceNeeds FrameFiles::distance() const {
    return distance_needs(preset_.image.maps, preset_.maps);
}

bool FrameFiles::needs_next() const {
    return std::any_of(maps_.begin(), maps_.end(), [](const Map* map) { return map->needs_next; });
}

WrittenFile FrameFiles::write_png(const Map& map,
                                  const MapImage& image,
                                  const std::filesystem::path& path) {
    const CodedImage coded = quantize(image, map.png_bits);
    const PngMetadata metadata = png_metadata(map, coded.color);
    const PngEncoding encoding{.filter = map.png_filter,
                               .compression = preset_.output.png_compression};
    std::unique_ptr<PngEncoder> encoder = take_encoder();
    const std::span<const std::byte> stream = std::visit(
        [&](const auto& codes) { return encoder->encode(codes.view(), metadata, encoding); },
        coded.codes);
    make_folders(path.parent_path());
    write_file(path, stream);
    const std::uint64_t bytes = stream.size();
    give_back(std::move(encoder));
    return {path,
            {{&map, samples_in_png(map, image, map.png_bits)}},
            bytes,
            std::visit([](const auto& codes) { return pixel_hash(codes.view()); }, coded.codes)};
}

// With what the map's codes stand for, which EXR files of floats need not say.
PngMetadata FrameFiles::png_metadata(const Map& map, bool color) const {
    PngMetadata metadata = png_;
    metadata.color = color;
    if (!metadata.text.empty()) {
        metadata.text.emplace_back("Map", map.name);
        metadata.text.emplace_back("Unit", map.unit);
    }
    if (!metadata.text.empty() && map.note != nullptr) {
        metadata.text.emplace_back("Note", map.note(preset_.maps));
    }
    return metadata;
}

ExrMetadata FrameFiles::exr_metadata(std::span<const Map* const> maps, bool color) const {
    ExrMetadata metadata = exr_;
    metadata.color = color;
    for (const Map* map : maps) {
        if (!metadata.text.empty() && map->note != nullptr) {
            metadata.text.emplace_back(fmt::format("Note {}", map->name), map->note(preset_.maps));
        }
    }
    return metadata;
}

// A lone map lies in no layer.
WrittenFile FrameFiles::write_exr(std::span<const Map* const> maps,
                                  ShownLayers& shown,
                                  const std::filesystem::path& path) const {
    const OutputOptions& output = preset_.output;
    ExrLayers channels(output.exr_numbers);
    WrittenFile written{.path = path, .maps = {}, .bytes = 0, .pixels = {}};
    for (const Map* map : maps) {
        MapImage image = draw(*map, shown, preset_.maps);
        written.maps.emplace_back(map, samples_in_exr(*map, image, output.exr_numbers));
        channels.add(
            maps.size() > 1 ? map->name : std::string_view(), map->channels, std::move(image));
    }
    ExrMetadata metadata = exr_metadata(maps, channels.has_colors());
    metadata.periodic = tiles(shown.layers.frame().domain);
    const Bytes stream = encode_exr(channels.channels(),
                                    metadata,
                                    {.compression = output.exr_compression,
                                     .zip_level = output.exr_level,
                                     .mip_levels = output.exr_layout == ExrLayout::MipLevels});
    make_folders(path.parent_path());
    write_file(path, stream);
    written.bytes = stream.size();
    written.pixels = pixel_hash(channels.channels());
    return written;
}

std::unique_ptr<PngEncoder> FrameFiles::take_encoder() {
    const std::scoped_lock lock(mutex_);
    if (idle_encoders_.empty()) {
        return std::make_unique<PngEncoder>();
    }
    std::unique_ptr<PngEncoder> encoder = std::move(idle_encoders_.back());
    idle_encoders_.pop_back();
    return encoder;
}

void FrameFiles::give_back(std::unique_ptr<PngEncoder> encoder) {
    const std::scoped_lock lock(mutex_);
    idle_encoders_.push_back(std::move(encoder));
}

}  // namespace foam::texgen
