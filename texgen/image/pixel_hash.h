// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the hash of the samples of an image file: 32 hexadecimal digits that do not depend on
/// compression or metadata. It is the XXH3-128 of the following blocks. A block is the line "NAMES
/// TYPE WIDTHxHEIGHT\n" followed by the samples: the top row first, channels interleaved, the
/// lowest byte first. A group of codes (u8, u16) is one block. Each channel of numbers (f16, f32,
/// u32) is one block; these follow in the order of their names. Halves are hashed in 16 bits, as
/// they are stored.
std::string pixel_hash(const Picture& picture);

/// Returns the XXH3-128 of a text as 32 hexadecimal digits.
std::string text_hash(std::string_view text);

}  // namespace foam::texgen
