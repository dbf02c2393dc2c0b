#pragma once

#include "texgen/raster/flag_places.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace foam::texgen {

/// Holds a pixel of so many bytes, in the order of memory, the first in the lowest bits.
template <std::size_t PixelBytes>
using PixelWord = std::conditional_t<PixelBytes <= 4, std::uint32_t, std::uint64_t>;

/// A row of pixels, in stretches of one value each.
template <std::size_t PixelBytes>
struct Stretches {
    /// A bit per pixel: whether a stretch begins there. One does at pixel 0.
    std::span<const std::uint64_t> flags;
    /// Where those are, and the width of the row.
    std::span<const std::uint16_t> begins;
    /// One per stretch, and kPixelsBeyond more, of any value.
    const PixelWord<PixelBytes>* pixels = nullptr;
};
inline constexpr std::size_t kPixelsBeyond = 16;

}  // namespace foam::texgen
