#pragma once

#include "texgen/image/picture.h"

#include <span>

namespace foam::texgen {

/// How two samples differ: by their numbers, or, as ids do, by being the same or not.
enum class Difference { Numbers, Ids };

/// A step where there should be none, beside those that are there anyway; means over the samples of
/// a border, or of a frame.
struct Seam {
    double across = 0.0;          // the step at the seam
    double largest_within = 0.0;  // of all other steps

    /// 0 where there is no step at the seam, infinite where there are no others.
    double ratio() const;
};

/// How images tile: the step from the last column to the first beside those from column to column,
/// and the same of rows.
struct TileSeams {
    Seam columns;
    Seam rows;
};

/// Returns the seams of one image. Precondition: all groups have one size.
TileSeams tile_seams(std::span<const ChannelGroup* const> groups, Difference difference);

/// The mean difference of two images of one form; infinite where they are of another form.
double step_between(std::span<const ChannelGroup* const> a,
                    std::span<const ChannelGroup* const> b,
                    Difference difference);

}  // namespace foam::texgen
