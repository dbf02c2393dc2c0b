#pragma once

#include "texgen/raster/stretches.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// By how many bytes paint_blocks may write beyond the end of a row.
inline constexpr std::size_t kBlockBytes = 128;

/// As paint_row, on any processor.
void paint_blocks(const Stretches<1>& stretches, std::uint8_t* row);
void paint_blocks(const Stretches<2>& stretches, std::uint8_t* row);
void paint_blocks(const Stretches<3>& stretches, std::uint8_t* row);
void paint_blocks(const Stretches<4>& stretches, std::uint8_t* row);
void paint_blocks(const Stretches<6>& stretches, std::uint8_t* row);
void paint_blocks(const Stretches<8>& stretches, std::uint8_t* row);

}  // namespace foam::texgen
