// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>
#include <span>

namespace foam::texgen {

/// A reduced picture of a frame, with three channels.
struct Thumbnail {
    Image<std::uint8_t> pixels;
    int number = 0;  // the number of the frame, not negative
};

/// Returns an image of thumbnails on a gray background, from left to right and from top to bottom.
/// The number of the frame is drawn below each thumbnail. A sheet of many thumbnails is about 1.5
/// times as wide as high. Precondition: all thumbnails have the same size. Throws
/// std::invalid_argument if there are no thumbnails.
Image<std::uint8_t> contact_sheet(std::span<const Thumbnail> thumbnails);

}  // namespace foam::texgen
