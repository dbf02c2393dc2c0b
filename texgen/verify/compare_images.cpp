// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/compare_images.h"

#include "core/files/file_io.h"
#include "texgen/image/compare.h"
#include "texgen/image/format.h"
#include "texgen/image/picture_layers.h"
#include "texgen/image/png.h"
#include "texgen/image/primaries.h"
#include "texgen/maps/all_maps.h"
#include "texgen/verify/normal_maps.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kMapKeyword = "Map";  // keyword of the text that names the map

// Returns the name of a picture's map, which its metadata contain under the keyword kMapKeyword, or
// an empty text if they do not contain it.
std::string map_in_texts(const Picture& picture) {
    for (const auto& [keyword, text] : picture.metadata.text) {
        if (keyword == kMapKeyword) {
            return text;
        }
    }
    return {};
}

// Returns the first text that is not empty.
std::string first_known(std::initializer_list<std::string> texts) {
    const auto* const found =
        std::ranges::find_if(texts, [](const std::string& text) { return !text.empty(); });
    return found != texts.end() ? *found : std::string();
}

bool is_map_of_colors(std::string_view map) {
    const auto maps = all_maps();
    const auto found = std::ranges::find(maps, map, &Map::name);
    return found != maps.end() && found->kind == MapKind::Color;
}

// Converts the colors of a picture to other primaries. `map` names the map of the channels without
// a layer. If `map` is empty, these channels count as colors. A layer is named after its map.
void change_primaries(Picture& picture, std::string_view map, Primaries to) {
    const Primaries from = picture.metadata.primaries;
    for (const PictureChannel& channel : channels_of(picture)) {
        const std::size_t dot = channel.name.rfind('.');
        if (channel.name == "R" && (map.empty() || is_map_of_colors(map))) {
            convert_colors(picture, "", from, to);
        } else if (channel.name.ends_with(".R") && is_map_of_colors(channel.name.substr(0, dot))) {
            convert_colors(picture, channel.name.substr(0, dot), from, to);
        }
    }
    picture.metadata.primaries = to;
}

// Compares the layers of two pictures that have the same layers.
std::vector<ComparedImage> compare_layers(const ImagePair& pair,
                                          Picture a,
                                          Picture b,
                                          const CompareOptions& options) {
    const std::string map_of_files = first_known({pair.map, map_in_texts(a), map_in_texts(b)});
    const std::vector<PictureLayer> left = split_into_layers(std::move(a));
    const std::vector<PictureLayer> right = split_into_layers(std::move(b));
    std::vector<ComparedImage> images;
    for (std::size_t k = 0; k < left.size(); ++k) {
        const std::string& layer = left[k].name;
        ComparedImage image{pair, first_known({options.map, layer, map_of_files}), layer};
        image.found =
            compare(left[k].picture,
                    right[k].picture,
                    options.limits_of(image.map),
                    is_normal_map(image.map) ? PixelContent::Normals : PixelContent::Numbers);
        image.verdict = image.found.verdict;
        images.push_back(std::move(image));
    }
    return images;
}

std::vector<ComparedImage> compare_pictures(const ImagePair& pair,
                                            Picture a,
                                            Picture b,
                                            const CompareOptions& options) {
    const std::string map = first_known({options.map, pair.map, map_in_texts(a), map_in_texts(b)});
    if (!have_same_layout(a, b)) {
        return {{pair, map, {}, Verdict::DifferentLayout}};
    }
    change_primaries(b, map, a.metadata.primaries);
    if (options.difference) {
        write_png(
            *options.difference, difference_picture(a, b).view(), {}, {.filter = PngFilter::Up});
    }
    return compare_layers(pair, std::move(a), std::move(b), options);
}

}  // namespace

std::vector<ComparedImage> compare_pair(const ImagePair& pair, const CompareOptions& options) {
    const std::string map = first_known({options.map, pair.map});
    if (pair.presence != Presence::Both) {
        return {{pair, map, {}, Verdict::Failure}};
    }
    try {
        return compare_pictures(pair, read_picture(pair.a), read_picture(pair.b), options);
    } catch (const InputError& error) {
        return {{pair, map, {}, Verdict::Unreadable, {}, error.what()}};
    }
}

Verdict worst_verdict(std::span<const ComparedImage> images) {
    Verdict worst = Verdict::Same;
    for (const ComparedImage& image : images) {
        worst = std::max(worst, image.verdict);
    }
    return worst;
}

}  // namespace foam::texgen
