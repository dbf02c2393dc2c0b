// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/pictures/source_picture.h"

#include <vector>

namespace foam::texgen {

/// Returns the main colors of a picture, from the darkest to the lightest. They are the centers of
/// at most `count` clusters of pixels in the color space Oklab. The clusters are found by k-means
/// (S. Lloyd, "Least squares quantization in PCM", 1982). Pixels count in proportion to their
/// opacity. Fewer colors are returned if the picture has fewer. Colors whose 8-bit sRGB codes agree
/// in the upper five bits of all channels count as one color. The result depends on nothing but the
/// picture and `count`. It is empty if all pixels are transparent. Precondition: count > 0.
std::vector<Srgb8> palette_of(const SourcePicture& picture, int count);

}  // namespace foam::texgen
