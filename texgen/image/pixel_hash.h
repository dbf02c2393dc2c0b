// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns the hash of the samples of a picture as 32 hexadecimal digits. The hash does not depend
/// on the compression or the metadata of a file.
///
/// The hash is the XXH3-128 of a sequence of blocks. A block begins with this line:
///
///     NAMES TYPE WIDTHxHEIGHT\n
///
/// The samples follow: the top row first, channels interleaved, in little-endian byte order. NAMES
/// are the channel names without separators. TYPE is u8, u16, f16, f32 or u32. Each group of codes
/// (u8, u16) is one block. Each channel of numbers (f16, f32, u32) is one block. The blocks of
/// numbers follow the blocks of codes, in alphabetical order of the channel names. Half floats are
/// hashed as the 16 bits that a file stores.
std::string pixel_hash(const Picture& picture);

/// Returns the XXH3-128 of a text as 32 hexadecimal digits.
std::string text_hash(std::string_view text);

}  // namespace foam::texgen
