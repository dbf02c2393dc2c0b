#pragma once

#include "texgen/maps/map_image.h"

#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Samples in the form that a PNG stores.
struct CodedImage {
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>> codes;
    bool color = false;  // sRGB; data otherwise
};

/// Encodes light as sRGB and opacity linearly, each as the nearest of 256 codes.
Image<std::uint8_t> srgb_codes(const ColorPixels& colors);

/// Encodes a map as integers of 8 or 16 bits. Colors become srgb_codes for any number of bits. Of
/// numbers, `low` becomes 0 and `high` the largest code; numbers beyond are clamped, and NaN
/// becomes 0. Two channels get a third one of 0, because PNG would take the second for an opacity.
/// Ids keep their lowest bits.
CodedImage quantize(const MapImage& map, int bits);

}  // namespace foam::texgen
