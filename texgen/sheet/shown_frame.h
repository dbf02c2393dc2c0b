// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/sheet/map_sequence.h"

#include <cstdint>

namespace foam::texgen {

/// The shade of gray behind transparent frames and between frames, as 8-bit sRGB.
inline constexpr std::uint8_t kGround = 0x2b;

/// A frame for display, with red, green and blue from 0 to 1. Colors are linear light, composited
/// over kGround. Data have the same values for any file format: those of the codes of a PNG.
struct ShownFrame {
    static constexpr int kColors = 3;

    Image<float> pixels;
    bool is_light = false;  // true for colors, false for data
};

/// Reads a frame of a map. Numbers are scaled from the manifest's `range` to [0, 1] and clamped.
/// Throws InputError if the file cannot be read or cannot be shown, for example if the manifest has
/// no range for a file of floats.
ShownFrame read_shown(const MapFile& file, const ManifestMap& map);

/// Reduces a frame to a smaller size. Each pixel is the area-weighted mean of the pixels that it
/// covers: a mean of linear light, or of the values of data. Because a pixel depends only on the
/// area that it covers, a reduced tile still tiles. Precondition: neither width nor height grows.
ShownFrame reduced(const ShownFrame& frame, int width, int height);

/// Encodes a frame as 8-bit codes: light as sRGB, data unchanged.
Image<std::uint8_t> codes_of(const ShownFrame& frame);

}  // namespace foam::texgen
