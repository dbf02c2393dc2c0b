// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Returns one channel of a picture at half its extents, rounded down but at least 1. Each pixel is
/// the mean over the area that it covers, so pixels that are exact means over the foam stay exact
/// means. A picture that tiles still tiles, as no pixel reaches across the border.
Image<float> mean_level(ImageView<const float> pixels, int channel);

/// Returns one channel at the extents of `mean_level`. Each pixel is the sample in the middle of
/// the area that it covers.
Image<std::uint32_t> central_level(ImageView<const std::uint32_t> pixels, int channel);

}  // namespace foam::texgen
