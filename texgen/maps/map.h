// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/png.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <string>
#include <string_view>

namespace foam::texgen {

struct MapOptions;

/// The quantity that is interpolated when one image of a map fades into another. Ids are never
/// interpolated.
enum class Mixing {
    Values,  // the samples of the images
    Slopes,  // for a map of normals: the slopes of the surface that has these normals
};

/// The kind of the samples of a map: the alternative of MapImage that the map draws.
enum class MapKind {
    Color,   // ColorPixels
    Number,  // NumberPixels
    Id,      // IdPixels
};

/// The properties of the images of a map. Only the properties of the images of the map `pressure`
/// depend on options (drawn_traits in all_maps.h).
struct MapTraits {
    std::string_view name;      // part of file names
    std::string_view meaning;   // a description in a few words
    std::string_view unit;      // unit of the values, and what a PNG stores
    std::string_view channels;  // such as "R G B"; colors of a patch also have "A"
    MapKind kind = MapKind::Number;
    int png_bits = 8;                        // bits per sample of a PNG
    PngFilter png_filter = PngFilter::None;  // PngEncoding::filter of its PNGs
    bool needs_next = false;                 // true if drawing needs the next frame
    bool needs_distance = false;             // true if the map uses DistanceField::distance
    SmoothImages smooth_images = SmoothImages::None;  // images that the map always uses
    bool shows_films = false;  // true if the map also uses the images of film_smooth_images
    Mixing mixing = Mixing::Values;
    bool shows_relief = false;  // true if the map depends on the relief (relief.h)
    // The name of the key that sets the range of the map. The range is one number: the number for
    // which a file of integer samples (codes), such as a PNG, stores its largest code. Numbers that
    // codes cannot store are clipped, and the program reports them. The name is empty for maps
    // whose numbers always fit or are clipped on purpose.
    std::string_view full_key{};
};

/// Returns the number of channels of a map, without the opacity of a patch.
constexpr int channel_count(const MapTraits& traits) {
    int spaces = 0;
    for (const char c : traits.channels) {
        spaces += c == ' ' ? 1 : 0;
    }
    return spaces + 1;
}

/// A map: its traits, and the functions that depend on options. Each function gets the options of
/// all maps and uses those that it needs.
struct Map : MapTraits {
    // Draws the map of the frame that `layers` contains. Pixels without opacity may have any
    // color. Call the function `draw` of cross_fade.h instead, which replaces these colors.
    MapImage (*draw)(FrameLayers& layers, const MapOptions& options) = nullptr;
    // Returns a text for the metadata of the map's files. The pointer is null if the map has no
    // such text.
    std::string (*note)(const MapOptions& options) = nullptr;
};

}  // namespace foam::texgen
