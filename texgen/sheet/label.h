// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The size of a character in pixels, without the gap of one pixel after it.
inline constexpr int kLetterWidth = 5;
inline constexpr int kLetterHeight = 7;

/// Returns the width of a text in pixels. Each pixel of a character becomes a square of
/// `magnification` pixels per side.
int label_width(std::string_view text, int magnification = 1);

/// Returns the lines of a text, none of which is wider than `width` pixels, unless `width` is less
/// than the width of a character. Lines end at a space or after one of "=,:_" if possible. Spaces
/// at the beginning and at the end of lines are left out.
std::vector<std::string> wrapped_label(std::string_view text, int width, int magnification = 1);

/// Draws a text in a shade of gray. The pixel (left, bottom) is its lower left corner. Characters
/// that are not printable ASCII are drawn as question marks. Precondition: the text fits into the
/// image.
void draw_label(ImageView<std::uint8_t> image,
                int left,
                int bottom,
                std::string_view text,
                std::uint8_t gray,
                int magnification = 1);

}  // namespace foam::texgen
