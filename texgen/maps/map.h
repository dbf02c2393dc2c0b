#pragma once

#include "texgen/image/png.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/map_options.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// What is mixed where one image of a map fades into another. Ids never are.
enum class Mixing {
    Values,
    Slopes,  // those that normals stand for
};

/// One map: all that drawing, choosing and documenting it needs.
struct Map {
    std::string_view name;      // as in file names
    std::string_view meaning;   // in a few words
    std::string_view unit;      // of its values, and what a PNG's codes stand for
    std::string_view channels;  // of a torus, "R G B"; colours of a patch have A as well
    int png_bits = 8;           // of a sample
    PngFilter png_filter = PngFilter::None;  // none for flat cells, up for what is smooth
    bool needs_next = false;                 // whether it asks for the frame after the one it shows
    DistanceNeeds (*distance)(const MapOptions& options) = nullptr;  // what it asks of them, if any
    double around = 0.0;  // in its last channel, around a patch
    Mixing mixing = Mixing::Values;
    std::string (*note)(const MapOptions& options) = nullptr;  // for its files, beside the unit
    MapImage (*draw)(FrameLayers& layers, const MapOptions& options) = nullptr;
};

/// Every map there is.
std::span<const Map> all_maps();

/// Their names, in the same order.
std::span<const std::string_view> map_names();

/// Throws std::invalid_argument that lists the names there are.
const Map& find_map(std::string_view name);

/// What several maps together ask of distances.
DistanceNeeds distance_needs(std::span<const std::string> names, const MapOptions& options);

/// The table of all maps in Markdown, as the README shows it.
std::string describe_maps_in_markdown();

}  // namespace foam::texgen
