// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <array>
#include <cstdint>
#include <vector>

namespace foam::texgen {

inline constexpr std::size_t kMaxChannels = 4;

/// One value per bubble and one value for all films. A value has 1 to kMaxChannels channels of 16
/// bits. Values are averaged, so they must be on a linear scale: linear light, not sRGB codes.
struct CellValues {
    std::size_t channels = 1;
    // The channels of bubble 0, then of bubble 1, and so on. In a patch these are followed by the
    // channels of the ghost bubble, of lone bubble 0, of lone bubble 1, and so on.
    std::vector<std::uint16_t> bubbles;
    std::array<std::uint16_t, kMaxChannels> film{};
};

/// Fills an image with bubbles and films. Each pixel is the mean of the values in it, weighted by
/// area and rounded to the nearest integer. The areas are exact, apart from the small errors that
/// texgen/raster/README.md lists. If films have a width of 0, the bubbles meet without gap or
/// overlap, so that the value of films is not visible.
///
/// The result has the same bits for any number of threads. If `cells.grid` is shifted, the image is
/// shifted cyclically (RasterGrid). Throws std::invalid_argument in these cases:
/// - The image and `cells.grid` differ in size.
/// - The image and the values differ in the number of channels.
/// - The number of channels is not from 1 to kMaxChannels.
/// - A bubble beside an arc, or the ghost bubble, has no value.
void fill_cells(const CellArcs& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image);

/// Fills an image with colors whose last channel is their opacity. The values must be
/// premultiplied, so that their means are premultiplied, too. The samples of the image are
/// straight: each mean color is divided by the mean opacity before any rounding, and the quotient
/// is rounded. If the mean opacity of a pixel before any rounding is 0 or negative, all its samples
/// are 0. The opacity can be negative only where rafts, or parts of one raft, overlap, or where the
/// foam is invalid. In all other respects, the function behaves like fill_cells.
void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image);

}  // namespace foam::texgen
