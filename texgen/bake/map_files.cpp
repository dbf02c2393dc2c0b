#include "texgen/bake/map_files.h"

#include "texgen/image/file_io.h"
#include "texgen/image/png.h"
#include "texgen/maps/map.h"
#include "texgen/maps/quantize.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <variant>

namespace foam::texgen {

namespace {

// What every file of a bake says about itself.
std::vector<std::pair<std::string, std::string>> texts_of_all(const Preset& preset) {
    return {{"Title", preset.description},
            {"Software", "foamtex " FOAMTEX_VERSION},
            {"Seed", fmt::format("{}", preset.seeding.seed)},
            {"Preset", to_toml(preset)}};
}

}  // namespace

MapFiles::MapFiles(const Preset& preset)
    : preset_(preset), pattern_(preset.output.pattern), texts_(texts_of_all(preset)) {
    for (const std::string& name : preset.image.maps) {
        maps_.push_back(&find_map(name));
    }
}

std::vector<std::filesystem::path> MapFiles::paths(int frame) const {
    std::vector<std::filesystem::path> all;
    for (const Map* map : maps_) {
        all.push_back(pattern_.path(preset_.name, map->name, frame));
    }
    return all;
}

void MapFiles::write(FrameLayers& layers, int frame) const {
    for (const Map* map : maps_) {
        write_png_of(*map, map->draw(layers, preset_.maps), frame);
    }
}

DistanceNeeds MapFiles::distance() const {
    return distance_needs(preset_.image.maps);
}

bool MapFiles::needs_next() const {
    return std::any_of(maps_.begin(), maps_.end(), [](const Map* map) { return map->needs_next; });
}

void MapFiles::write_png_of(const Map& map, const MapImage& image, int frame) const {
    const CodedImage coded = quantize(image, map.png_bits);
    const PngMetadata metadata{.color = coded.color, .text = texts_of(map)};
    const PngEncoding encoding{.filter = map.png_filter};
    const std::filesystem::path path = pattern_.path(preset_.name, map.name, frame);
    make_folders(path.parent_path());
    std::visit([&](const auto& codes) { write_png(path, codes.view(), metadata, encoding); },
               coded.codes);
}

MapFiles::Texts MapFiles::texts_of(const Map& map) const {
    Texts texts = texts_;
    texts.emplace_back("Map", map.name);
    texts.emplace_back("Unit", map.unit);
    if (map.note != nullptr) {
        texts.emplace_back("Note", map.note(preset_.maps));
    }
    return texts;
}

}  // namespace foam::texgen
