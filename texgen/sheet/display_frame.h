// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/sheet/map_sequence.h"

#include <cstdint>

namespace foam::texgen {

/// The gray behind transparent frames and between the frames of a contact sheet, as an 8-bit sRGB
/// code.
inline constexpr std::uint8_t kBackgroundGray = 0x2b;

/// A frame for display, with red, green and blue from 0 to 1. Colors are linear light; if they have
/// an opacity (MapSamples::alpha), they are composited over kBackgroundGray. In a map of data, 0
/// and 1 stand for the numbers that the smallest and the largest code (integer sample) of a PNG
/// represent. This also holds if the file is not a PNG.
struct DisplayFrame {
    static constexpr int kColors = 3;

    Image<float> pixels;    // three channels
    bool is_light = false;  // true for colors, false for data
};

/// Reads a frame of a map. In a file of floats, the channels R, G and B are shown as red, green and
/// blue. If there is no R, the channels X, Y and Z are shown instead. If there is neither R nor X,
/// the channel Y is shown as gray. Floats are scaled to [0, 1] from the range in the manifest
/// (MapSamples::range), if there is one, and clamped.
///
/// Throws InputError if the file cannot be read or lacks the layer of the map. If the samples are
/// not codes of 8 or 16 bits, also throws InputError in these cases:
/// - no channel R, X or Y has samples of floats;
/// - the map is data, and the manifest does not give its range.
DisplayFrame read_display_frame(const MapFile& file, const ManifestMap& map);

/// Returns a frame reduced to a smaller size. Each new pixel is the mean of the old pixels that it
/// covers, weighted by area. Colors are averaged as linear light. Because a new pixel depends only
/// on the area that it covers, a reduced frame still tiles if the frame tiles. Precondition:
/// neither width nor height grows.
DisplayFrame reduced(const DisplayFrame& frame, int width, int height);

/// Returns a frame as 8-bit codes. Values are clamped to [0, 1]; colors are encoded as sRGB, data
/// linearly.
Image<std::uint8_t> codes_of(const DisplayFrame& frame);

}  // namespace foam::texgen
