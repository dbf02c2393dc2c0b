// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/map_image.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// The smallest and the largest number of an image, and the fraction of its numbers that are
/// clipped in a file of integer samples (codes). A PNG is such a file.
struct NumberExtent {
    // The smallest and the largest finite number, in the unit of the map; 0 if no number is finite.
    double smallest = 0.0;
    double largest = 0.0;
    // The fraction of the samples that are clipped. A finite number is clipped if it is below
    // NumberPixels::low or above NumberPixels::high by more than half a step of a 16-bit code.
    double clipped = 0.0;

    friend bool operator==(const NumberExtent&, const NumberExtent&) = default;
};

/// Returns the extent of the numbers of an image.
NumberExtent extent_of(const NumberPixels& numbers);

/// Returns the extent of the numbers in some channels of an image. `channels` are the indices of
/// these channels.
NumberExtent extent_of(const NumberPixels& numbers, std::span<const std::size_t> channels);

/// Returns the extent of two images together: the smallest and the largest number of both, and the
/// larger of the two clipped fractions. Precondition: each image has at least one finite number.
NumberExtent joined(const NumberExtent& one, const NumberExtent& other);

}  // namespace foam::texgen
