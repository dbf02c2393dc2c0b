// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <span>

namespace foam::texgen {

/// Selects how two samples are compared. The difference of two numbers a and b is |a - b|; codes
/// are compared as integers, from 0 to 255 or 65535. The difference of two ids is 1 if the ids
/// differ and 0 if they are equal.
enum class Difference { Numbers, Ids };

/// The step across a seam, and the largest other step. A step is the mean difference of the samples
/// of two adjacent columns, rows or frames. A seam is the border of an image that should tile, or
/// the change from the last frame of a loop to the first.
struct Seam {
    double across = 0.0;          // the step across the seam
    double largest_within = 0.0;  // the largest of all other steps

    /// Returns across / largest_within. Returns 0 if `across` is 0. Returns infinity if a step is
    /// infinite or NaN, or if `largest_within` is 0 and `across` is not.
    double ratio() const;
};

/// The largest step across a seam, and the largest of all other steps, over several frames. NaN
/// counts as the largest step.
struct WorstSeam {
    Seam seam;
    int frame = 0;  // the first frame with the largest step across the seam; 0 if there is no frame

    /// Adds the seam of the frame with the given number.
    void add(const Seam& one, int number);
};

/// The seams of an image that should tile. `columns` is the seam between the last column and the
/// first column; its other steps are the steps between adjacent columns within the image. `rows` is
/// the corresponding seam of the rows.
struct TileSeams {
    Seam columns;
    Seam rows;
};

/// Returns the seams of one image, whose channels are in one or more groups. All steps are 0 if
/// there are no groups. Precondition: all groups have the same size.
TileSeams tile_seams(std::span<const ChannelGroup* const> groups, Difference difference);

/// Returns the mean difference of the samples of two images, which are given as lists of groups.
/// Returns infinity if the images differ in size, channels or the type of samples in memory
/// (Samples), or have no groups.
double step_between(std::span<const ChannelGroup* const> a,
                    std::span<const ChannelGroup* const> b,
                    Difference difference);

}  // namespace foam::texgen
