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
    Values,
    Slopes,  // for a map of normals: the slopes of its surface
};

/// The conditions under which a map uses the smooth distance to films.
enum class SmoothDistance {
    Unused,
    Used,
    UsedByFilms,  // used if films are wet or shaded (distance_of_look)
};

/// The properties of a map that do not depend on options.
struct MapTraits {
    std::string_view name;                   // part of file names
    std::string_view meaning;                // a description in a few words
    std::string_view unit;                   // unit of the values, and their range in a PNG
    std::string_view channels;               // such as "R G B"; colors of a patch also have A
    int png_bits = 8;                        // bits per sample of a PNG
    PngFilter png_filter = PngFilter::None;  // None for flat cells, Up for smooth maps
    bool needs_next = false;                 // true if drawing needs the next frame
    SmoothDistance smooth_distance = SmoothDistance::Unused;
    double around = 0.0;  // the value of the last channel around a patch
    Mixing mixing = Mixing::Values;
};

/// A map: its traits, and the functions that depend on options. Each function gets the options of
/// all maps and uses its own.
struct Map : MapTraits {
    MapImage (*draw)(FrameLayers& layers, const MapOptions& options) = nullptr;
    // Returns a text for the metadata of the files of the map. May be null.
    std::string (*note)(const MapOptions& options) = nullptr;
};

}  // namespace foam::texgen
