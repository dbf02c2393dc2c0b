// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/cross_fade.h"
#include "texgen/maps/map.h"
#include "texgen/maps/map_image.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

struct MapOptions;

/// The source of one channel of a packed image: a channel of a map, or a constant.
struct PackedChannel {
    const Map* map = nullptr;  // nullptr for a constant
    int channel = 0;           // index of the channel of the map
    bool inverted = false;     // true if the channel holds 1 minus the sample
    double constant = 0.0;     // from 0 to 1; only used without a map
    std::string text;          // the text that gives the channel, such as "1-roughness"
};

/// A packed image: an image whose channels come from different maps, as engines expect of a
/// material. A sample of a map of numbers is packed as the fraction that a PNG of the map stores:
/// 0 for the smallest number of its range, 1 for the largest. The map `pressure` is packed as
/// numbers even if pressure.colormap is set.
struct Packing {
    std::string name;                     // takes the place of {map} in file names
    std::vector<PackedChannel> channels;  // R, G, B and, if there are four, A
    int bits = 8;  // bits per sample of a file of codes (integer samples), 8 or 16
    // If true, R, G and B are colors, which are encoded as sRGB. If false, all channels are data.
    bool is_color = false;
};

/// The largest number of characters of a word that may take the place of {map} in file names.
inline constexpr std::size_t kMaxFileWordLength = 64;

/// Returns true if a text may take the place of {map} in file names: it has 1 to kMaxFileWordLength
/// letters, digits, '_' or '-'.
bool is_file_word(std::string_view text);

/// Parses a packing. The text is `NAME=R,G,B` or `NAME=R,G,B,A`. It begins with `NAME:16=` for 16
/// bits per sample; `NAME:8=` means the same as `NAME=`. Each channel is one of these:
///
///     occlusion     a map with one channel
///     1-roughness   1 minus a map with one channel
///     normal.X      a channel of a map with several channels; 1-normal.X is also possible
///     0.5           a constant from 0 to 1
///
/// Either each of R, G and B is a channel of a map of colors, or none of them is; A is never a
/// color. Colors have 8 bits per sample and cannot be inverted. Maps of integers (MapKind::Id)
/// cannot be packed. NAME satisfies is_file_word. It must not be the name of a map, in upper or
/// lower case. Throws std::invalid_argument for any other text. The message says which part is
/// wrong.
Packing parse_packing(std::string_view text);

/// Returns the maps of a packing, each once.
std::vector<const Map*> maps_in(const Packing& packing);

/// Draws a packed image. If packing.is_color is true, the image holds colors, which are not
/// multiplied by the opacity of a patch, and the numbers of A are clamped to 0 to 1. If
/// packing.is_color is false, the image holds numbers, which are outside of 0 to 1 if they are
/// outside the range of their map.
MapImage draw_packed(const Packing& packing, ShownLayers& content, const MapOptions& options);

}  // namespace foam::texgen
