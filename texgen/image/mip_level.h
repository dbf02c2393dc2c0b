// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Returns one channel of a picture at half the width and half the height, each rounded down but at
/// least 1. Each pixel of the result is the mean of the picture over the area that the pixel
/// covers. If width and height are even, and the pixels of the picture are exact means over areas
/// of the foam, the pixels of the result are exact means, too. If the picture tiles, the result
/// tiles, too. `channel` is the index of the channel.
Image<float> mean_level(ImageView<const float> pixels, int channel);

/// Returns one channel of a picture at the width and height of the result of mean_level. Each pixel
/// of the result has the value of the picture at the center of the area that the pixel covers. If
/// the center is on the border between two columns of the picture, the right column is used. If it
/// is on the border between two rows, the upper row is used.
Image<std::uint32_t> central_level(ImageView<const std::uint32_t> pixels, int channel);

}  // namespace foam::texgen
