// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <array>
#include <cstdint>

namespace foam::texgen {

/// Gives every fully transparent pixel a color. The image has straight linear colors (not sRGB
/// codes) in three channels and opacity in the fourth. Filters that ignore opacity, such as those
/// of textures and mip maps, then mix in no color that the picture does not show.
///
/// The color is a mean weighted by opacity. It is the mean of the eight neighbors if any of them
/// has an opacity above 0, so that filters between pixels stay within the colors of the edge.
/// Otherwise it is the mean of the smallest square of 2, 4, 8, ... pixels around the pixel that has
/// an opacity above 0, among the squares that mip maps average. In an image without any opacity all
/// pixels get `fallback`.
void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback);

}  // namespace foam::texgen
