// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <span>

namespace foam::texgen {

/// The measure of the difference of two samples. It is the absolute difference for numbers. For ids
/// it is 1 if they differ and 0 if they are equal.
enum class Difference { Numbers, Ids };

/// The step across a possible seam, compared with the largest step elsewhere. A step is the mean
/// difference of the samples of two adjacent columns, rows or frames.
struct Seam {
    double across = 0.0;          // the step across the seam
    double largest_within = 0.0;  // the largest of all other steps

    /// Returns across / largest_within. The ratio is 0 if there is no step across the seam, and
    /// infinite if there is one but all other steps are 0.
    double ratio() const;
};

/// The seams of a tile. For columns, the step from the last column to the first is compared with
/// the steps between adjacent columns; likewise for rows.
struct TileSeams {
    Seam columns;
    Seam rows;
};

/// Returns the seams of one image. Precondition: all groups have the same size.
TileSeams tile_seams(std::span<const ChannelGroup* const> groups, Difference difference);

/// Returns the mean difference of the samples of two images, or infinity if the images differ in
/// size, channels or type, or are empty.
double step_between(std::span<const ChannelGroup* const> a,
                    std::span<const ChannelGroup* const> b,
                    Difference difference);

}  // namespace foam::texgen
