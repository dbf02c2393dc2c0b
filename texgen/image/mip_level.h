// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Returns one channel of a picture at half its extents, rounded down but at least 1. Each pixel is
/// the mean over the area that it covers. If the pixels of the picture are exact means over the
/// foam, so are the pixels of the result. A picture that tiles still tiles, because no pixel covers
/// area on both sides of the border.
Image<float> mean_level(ImageView<const float> pixels, int channel);

/// Returns one channel of a picture at the same extents as mean_level. Each pixel is the sample in
/// the middle of the area that it covers.
Image<std::uint32_t> central_level(ImageView<const std::uint32_t> pixels, int channel);

}  // namespace foam::texgen
