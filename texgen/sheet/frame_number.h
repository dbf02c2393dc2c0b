#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Of the digits, in pixels.
inline constexpr int kDigitWidth = 5;
inline constexpr int kDigitHeight = 7;

/// The width of a number of 0 or more, in pixels.
int number_width(int number);

/// Draws a number in a grey, its lower left corner at a pixel; it has to fit into the image.
void draw_number(
    ImageView<std::uint8_t> image, int left, int bottom, int number, std::uint8_t grey);

}  // namespace foam::texgen
