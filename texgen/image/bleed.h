#pragma once

#include "texgen/image/image.h"

#include <array>
#include <cstdint>

namespace foam::texgen {

/// Gives every pixel of no opacity a colour: straight colours (light, not sRGB) in three channels,
/// opacity in the fourth. Filters that mix colours without regard to opacity, as those of textures
/// and their mip maps do, then find no colour that is not there.
///
/// The colour is a mean weighted by opacity: of the eight pixels beside it, so that filters between
/// pixels stay within the colours of the edge; where none of these has any opacity, of the smallest
/// square of 2, 4, 8, ... pixels around it that has, among those that mip maps are the means of. An
/// image of no opacity at all becomes `fallback`.
void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback);

}  // namespace foam::texgen
