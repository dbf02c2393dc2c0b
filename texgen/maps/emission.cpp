// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/emission.h"

#include "texgen/maps/color_loops.h"

#include <array>
#include <cstddef>

namespace foam::texgen {

ColorPixels draw_emission(FrameLayers& layers, const SurfaceColors& surface, double glow) {
    ColorPixels emission = draw_surface_colors(layers, surface);
    const Image<float> fractions = glow_fractions(layers, surface, emission, glow);
    change_colors(
        emission.pixels,
        [fractions = fractions.samples().data()](const std::array<float, 3>& color, std::size_t k) {
            return std::array{
                fractions[k] * color[0], fractions[k] * color[1], fractions[k] * color[2]};
        });
    emission.fallback = {};
    return emission;
}

}  // namespace foam::texgen
