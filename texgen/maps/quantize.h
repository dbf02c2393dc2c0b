// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/map_image.h"

#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Samples in the form that a PNG stores.
struct CodedImage {
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>> codes;
    bool color = false;  // true for sRGB colors, false for data
};

/// Encodes colors as 8-bit codes, rounded to nearest. Linear light becomes sRGB; opacity stays
/// linear.
Image<std::uint8_t> srgb_codes(const ColorPixels& colors);

/// Encodes the image of a map as integers of 8 or 16 bits. Colors always become 8-bit srgb_codes.
/// NumberPixels::low becomes code 0 and NumberPixels::high the largest code; numbers outside this
/// range are clamped, and NaN becomes code 0. Numbers with two channels get a third channel of 0,
/// because the second channel of a PNG with two channels is an opacity. Ids keep their lowest
/// `bits` bits. Precondition: `bits` is 8 or 16.
CodedImage quantize(const MapImage& map, int bits);

}  // namespace foam::texgen
