#pragma once

#include "texgen/image/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foam::texgen {

inline constexpr std::size_t kMaxPalette = 256;

/// Red, green, blue and opacity; 255 is opaque.
using PaletteColor = std::array<std::uint8_t, 4>;

/// A picture as numbers of colours.
struct IndexedImage {
    std::vector<PaletteColor> palette;  // in the order in which they appear, from the top on
    Image<std::uint8_t> indices;        // one channel
};

/// The same picture with a palette; none if it has more than kMaxPalette colours.
/// Takes 3 or 4 channels.
std::optional<IndexedImage> with_palette(ImageView<const std::uint8_t> pixels);

}  // namespace foam::texgen
