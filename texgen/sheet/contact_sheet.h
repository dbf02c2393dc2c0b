#pragma once

#include "texgen/image/image.h"

#include <cstdint>
#include <span>

namespace foam::texgen {

/// A small picture of a frame, of three channels.
struct Thumbnail {
    Image<std::uint8_t> pixels;
    int number = 0;  // of the frame, not negative
};

/// Thumbnails of one size on a grey ground, from left to right and from the top down, wider than
/// high, with the number of its frame under each. Throws std::invalid_argument for none.
Image<std::uint8_t> contact_sheet(std::span<const Thumbnail> thumbnails);

}  // namespace foam::texgen
