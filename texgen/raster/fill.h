#pragma once

#include "texgen/image/image.h"
#include "texgen/raster/cell_arcs.h"

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
    // The channels of bubble 0, of bubble 1, ...; of a patch then those of what is around it, of
    // lone bubble 0, of lone bubble 1, ...
    std::vector<std::uint16_t> cells;
    std::array<std::uint16_t, kMaxChannels> film{};
};

/// What a 16-bit value is written as.
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

/// Fills an image with colours whose last channel is their opacity. The values come premultiplied,
/// so that means are, too; the samples are straight: each colour over the opacity, from the whole
/// precision of both. Where nothing is opaque, all samples are 0.
void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image);

/// As fill_cells, each mean then encoded. As it becomes 8 bits, areas are rounded to 2^-15 pixel,
/// a sixteenth of what ends of arcs are; the parts of a pixel still add up to exactly 1.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                const Encoding<std::uint8_t>& encoding,
                int threads,
                ImageView<std::uint8_t> image);

}  // namespace foam::texgen
