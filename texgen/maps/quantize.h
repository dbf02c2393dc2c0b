#pragma once

#include "texgen/maps/map_image.h"

#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Samples as a PNG stores them.
struct CodedImage {
    std::variant<Image<std::uint8_t>, Image<std::uint16_t>> codes;
    bool color = false;  // sRGB; data otherwise
};

/// Light as sRGB and opacity as it is, each as the nearest of 256 codes.
Image<std::uint8_t> srgb_codes(const ColorPixels& colors);

/// A map as integers of 8 or 16 bits. Colours become srgb_codes, whatever the bits. Of numbers,
/// `low` becomes 0 and `high` the largest code, what lies beyond these is held at them, and NaN
/// becomes 0; two channels get a third one of 0, as PNG would take the second for an opacity.
/// Ids keep their lowest bits.
CodedImage quantize(const MapImage& map, int bits);

}  // namespace foam::texgen
