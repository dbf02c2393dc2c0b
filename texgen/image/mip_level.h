#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// One channel of a picture at half its extents, rounded down but at least 1. Each pixel is the
/// mean of what it covers, by area: pixels that are means of a foam stay so, and what tiles still
/// does, as no pixel reaches across the border.
Image<float> mean_level(ImageView<const float> pixels, int channel);

/// The same with the sample in the middle of what a pixel covers.
Image<std::uint32_t> central_level(ImageView<const std::uint32_t> pixels, int channel);

}  // namespace foam::texgen
