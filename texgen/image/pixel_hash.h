#pragma once

#include "texgen/image/exr.h"
#include "texgen/image/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

// What an image file holds as a number: 32 hexadecimal digits, the same for the same pixels however
// they are compressed, whatever texts stand beside them. XXH3-128 of, for every block of samples,
// the line "NAMES TYPE WIDTHxHEIGHT\n" and then the samples, those of the top row first, channels
// interleaved, the lowest byte first. A PNG is one block; an EXR is a block per channel, in the
// order of their names.

/// Of a PNG of these samples, 8 bits (u8) or 16 (u16), 1 to 4 channels (Y, YA, RGB, RGBA).
std::string pixel_hash(ImageView<const std::uint8_t> pixels);
std::string pixel_hash(ImageView<const std::uint16_t> pixels);

/// Of an EXR of these channels, in any order: Half (f16), Float (f32) or Uint (u32); numbers count
/// as the file stores them.
std::string pixel_hash(std::span<const ExrChannel> channels);

/// Of an EXR that was read.
std::string pixel_hash(const ExrImage& image);

/// Of any text.
std::string text_hash(std::string_view text);

}  // namespace foam::texgen
