// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Returns an image whose samples count up from 0, modulo 256.
inline Image<std::uint8_t> numbered_codes(int width, int height, int channels) {
    Image<std::uint8_t> image(width, height, channels);
    std::uint8_t value = 0;
    for (std::uint8_t& sample : image.samples()) {
        sample = value++;
    }
    return image;
}

/// Returns an image of multiples of 1/8 from -4 to 27.875, which half floats store exactly.
inline Image<float> numbered_floats(int width, int height, int channels) {
    Image<float> image(width, height, channels);
    int k = 0;
    for (float& sample : image.samples()) {
        sample = static_cast<float>(k++ % 256) / 8.0F - 4.0F;
    }
    return image;
}

}  // namespace foam::texgen
