#pragma once

#include "texgen/image/image.h"
#include "texgen/sheet/map_sequence.h"

#include <cstdint>

namespace foam::texgen {

/// Grey that transparent frames are shown on, and that lies between frames; 8-bit sRGB.
inline constexpr std::uint8_t kGround = 0x2b;

/// A frame for the eye, red, green and blue from 0 to 1: colours as light, over kGround where they
/// are not opaque; data as a PNG codes it, whatever the file's format.
struct ShownFrame {
    Image<float> pixels;
    bool is_light = false;
};

/// Reads a frame of a map. Numbers are scaled from the manifest's `range` and clamped to it. Throws
/// InputError, also for a file of numbers whose range the manifest does not tell.
ShownFrame read_shown(const MapFile& file, const ManifestMap& map);

/// Means by area: of light, and of data as it is. Pixels of what tiles look at nothing beyond their
/// own place, so it still does. No extent may grow.
ShownFrame reduced(const ShownFrame& frame, int width, int height);

/// As a PNG stores it: light as sRGB, data as it is.
Image<std::uint8_t> codes_of(const ShownFrame& frame);

}  // namespace foam::texgen
