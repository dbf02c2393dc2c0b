#pragma once

#include "texgen/raster/stretches.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// By how many bytes paint_blocks may write beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// As paint_row, on any processor.
template <std::size_t PixelBytes>
void paint_blocks(const Stretches<PixelBytes>& stretches, std::uint8_t* row);

}  // namespace foam::texgen
