#pragma once

#include "texgen/image/picture.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the hash of what an image file holds: 32 hexadecimal digits that depend on the samples
/// alone, not on compression or metadata. It is the XXH3-128 of the following blocks. A block is
/// the line "NAMES TYPE WIDTHxHEIGHT\n" and then the samples, those of the top row first, channels
/// interleaved, the lowest byte first. A group of codes (u8, u16) is one block; of groups of
/// numbers (f16, f32, u32), each channel is one block, in the order of names. Halves count as they
/// are stored.
std::string pixel_hash(const Picture& picture);

/// Returns the same hash of a text.
std::string text_hash(std::string_view text);

}  // namespace foam::texgen
