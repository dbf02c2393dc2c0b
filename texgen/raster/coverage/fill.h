#pragma once

#include "texgen/image/image.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

inline constexpr std::size_t kMaxChannels = 4;

/// One value per bubble and one for films: 1 to kMaxChannels channels of 16 bits, in a scale in
/// which an average makes sense (light, not sRGB).
struct CellValues {
    std::size_t channels = 1;
    // The channels of bubble 0, bubble 1, ...; in a patch then those of the ghost, lone bubble 0,
    // lone bubble 1, ...
    std::vector<std::uint16_t> cells;
    std::array<std::uint16_t, kMaxChannels> film{};
};

/// The sample that each 16-bit value is written as.
template <class Sample>
using Encoding = std::array<Sample, 65536>;

/// Fills an image with cells and films. Each pixel is the mean of the values in it, weighted by
/// exact area (to the precision of subpixels) and rounded to the nearest. With films of no width
/// the cells meet without gap or overlap, so that no film's value shows.
///
/// The same bits for any number of threads; a shift of the grid is an exact cyclic shift of the
/// image. Throws std::invalid_argument if the image does not have the size of the grid and the
/// channels of the values, or a bubble has no value.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image);

/// Fills an image with colors whose last channel is their opacity. The values are premultiplied, so
/// that their means are, too; the samples are straight: each color divided by the opacity, both at
/// full precision. Where nothing is opaque, all samples are 0.
void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image);

/// Fills an image like the first fill_cells and encodes each mean. As samples have 8 bits, areas
/// are rounded to 2^-15 pixel; the parts of a pixel still add up to exactly 1.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                const Encoding<std::uint8_t>& encoding,
                int threads,
                ImageView<std::uint8_t> image);

}  // namespace foam::texgen
