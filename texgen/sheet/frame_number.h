// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The size of a digit in pixels.
inline constexpr int kDigitWidth = 5;
inline constexpr int kDigitHeight = 7;

/// Returns the width of a number in pixels. Precondition: the number is not negative.
int number_width(int number);

/// Draws a number in a shade of gray. The pixel (left, bottom) is its lower left corner.
/// Precondition: the number is not negative and fits into the image.
void draw_number(
    ImageView<std::uint8_t> image, int left, int bottom, int number, std::uint8_t gray);

}  // namespace foam::texgen
