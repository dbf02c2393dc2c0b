// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/gradient_noise.h"

namespace foam::texgen {

NoiseValue octave_noise(const Vec2& point, std::uint32_t seed, int octaves) {
    NoiseValue sum;
    double size = 1.0;
    for (int k = 0; k < octaves; ++k) {
        const NoiseValue one =
            gradient_noise(point.x() / size, point.y() / size, seed_of_octave(seed, k));
        sum.value += kNoiseScale * size * one.value;
        sum.slope_x += kNoiseScale * one.slope_x;
        sum.slope_y += kNoiseScale * one.slope_y;
        size *= 0.5;
    }
    return sum;
}

}  // namespace foam::texgen
