// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

inline constexpr std::size_t kMaxChannels = 4;

/// One value per bubble and one for films: 1 to kMaxChannels channels of 16 bits, on a scale on
/// which averages are meaningful (light, not sRGB).
struct CellValues {
    std::size_t channels = 1;
    // The channels of bubble 0, then of bubble 1, ...; in a patch these are followed by the
    // channels of the ghost bubble, lone bubble 0, lone bubble 1, ...
    std::vector<std::uint16_t> cells;
    std::array<std::uint16_t, kMaxChannels> film{};
};

/// A table of the samples that encode the 16-bit values.
template <class Sample>
using Encoding = std::array<Sample, 65536>;

/// Fills an image with cells and films. Each pixel is the mean of the values in it, weighted by
/// exact area (to the precision of subpixels) and rounded to the nearest integer. With films of no
/// width the cells meet without gap or overlap, so that the value of films is not visible.
///
/// The result is the same to the bit for any number of threads. A shift of the grid shifts the
/// image cyclically, to the bit. Throws std::invalid_argument if the image does not have the size
/// of the grid and the channels of the values, or if a bubble has no value.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image);

/// Fills an image with colors whose last channel is their opacity. The values must be
/// premultiplied, so that their means are premultiplied, too. The samples of the image are
/// straight: each mean color is divided by the mean opacity before either is rounded. Samples of
/// pixels without opacity are 0. In all other respects, the function behaves like
/// fill_cells.
void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image);

/// Fills an image like the first fill_cells and encodes each mean. Because samples have only 8
/// bits, areas are rounded to 2^-15 pixel; the areas in a pixel still add up to exactly 1.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                const Encoding<std::uint8_t>& encoding,
                int threads,
                ImageView<std::uint8_t> image);

}  // namespace foam::texgen
