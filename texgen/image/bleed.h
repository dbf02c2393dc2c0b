// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <array>
#include <cstdint>

namespace foam::texgen {

/// Gives every fully transparent pixel a color. The image has straight linear colors (not sRGB
/// codes) in three channels and opacity in the fourth. Filters that ignore opacity, such as texture
/// filters and mip maps, then mix in only colors that the picture shows.
///
/// The color is a mean weighted by opacity. It is the mean of the eight neighbors if any of them
/// has an opacity above 0, so that interpolation between pixels yields only colors of the edge.
/// Otherwise it is the mean of a square of 2, 4, 8, ... pixels per side that a texel of a mip map
/// covers: the smallest such square that contains the pixel and has an opacity above 0. If the
/// whole image is transparent, all pixels get `fallback`.
void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback);

}  // namespace foam::texgen
