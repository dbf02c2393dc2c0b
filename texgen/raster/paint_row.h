#pragma once

#include "texgen/raster/stretches.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Whether caches keep what is stored. Past them no line is read before it is written, and what
/// they hold stays there; but a row has to begin at such a line, and other threads see it only
/// after finish_stores.
enum class Stores { Kept, Streamed };

/// For rows of so many bytes, one after the other, that begin at `first`: kept if caches are likely
/// to have them when they are read, if the rows do not all begin at a line of a cache, or if this
/// processor can do nothing else.
Stores stores_for(const void* first, std::size_t row_bytes, std::size_t rows);
void finish_stores();

/// How many bytes paint_row may write of a row, whose own are the first of them.
std::size_t painted_bytes(std::size_t width, std::size_t pixel_bytes);

/// Writes a row of pixels of 1, 2, 3, 4, 6 or 8 bytes.
template <std::size_t PixelBytes>
void paint_row(const Stretches<PixelBytes>& stretches, Stores stores, std::uint8_t* row);

}  // namespace foam::texgen
