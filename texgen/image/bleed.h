// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <array>
#include <cstdint>

namespace foam::texgen {

/// Gives every fully transparent pixel a color. Filters that ignore opacity, such as texture
/// filters and mip maps, then mix in only colors that the picture shows. The first three channels
/// of the image are a color in linear light (not sRGB codes), which is not multiplied by the
/// opacity. The fourth channel is the opacity.
///
/// The color of a transparent pixel is a mean weighted by opacity. If any of the eight neighbors of
/// the pixel has an opacity above 0, the color is the mean of the neighbors. At the edge of the
/// foam, interpolation between pixels then uses no other colors than those of nearby pixels of the
/// foam. If all eight neighbors are transparent, the color is the mean of a square of pixels that
/// one texel of a mip map covers. Such squares have 2, 4, 8, ... pixels per side. Among the squares
/// that contain the pixel, the smallest one with an opacity above 0 is used. If the whole image is
/// transparent, all pixels get the color `fallback`.
void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback);

}  // namespace foam::texgen
