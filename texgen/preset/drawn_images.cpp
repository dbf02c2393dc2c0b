// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/drawn_images.h"

#include "texgen/maps/all_maps.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace foam::texgen {

std::vector<DrawnImage> drawn_images(const Preset& preset) {
    std::vector<DrawnImage> images;
    for (const std::string& name : preset.image.maps) {
        images.emplace_back(find_map(name), preset.maps);
    }
    for (const std::string& packing : preset.output.pack) {
        images.emplace_back(parse_packing(packing));
    }
    return images;
}

std::vector<const Map*> source_maps(const Preset& preset) {
    std::vector<const Map*> maps;
    for (const DrawnImage& image : drawn_images(preset)) {
        for (const Map* const map : image.sources()) {
            if (std::ranges::find(maps, map) == maps.end()) {
                maps.push_back(map);
            }
        }
    }
    return maps;
}

bool needs_next_frame(const Preset& preset) {
    return std::ranges::any_of(source_maps(preset), &Map::needs_next);
}

std::vector<std::string> source_map_names(const Preset& preset) {
    std::vector<std::string> names;
    for (const Map* const map : source_maps(preset)) {
        names.emplace_back(map->name);
    }
    return names;
}

std::string file_word(const Preset& preset, std::string_view image) {
    for (const std::string& name : preset.output.names) {
        const NamedMap named = parse_named_map(name);
        if (named.map == image) {
            return named.word;
        }
    }
    return std::string(image);
}

void check_file_words(const Preset& preset) {
    std::vector<std::string> words;
    for (const DrawnImage& image : drawn_images(preset)) {
        const std::string word = file_word(preset, image.name());
        if (std::ranges::find(words, word) != words.end()) {
            throw std::invalid_argument(
                fmt::format("two images would have the word '{}' in their file names; see "
                            "output.pack and output.names",
                            word));
        }
        words.push_back(word);
    }
}

}  // namespace foam::texgen
