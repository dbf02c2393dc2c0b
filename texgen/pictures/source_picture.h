// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstdint>
#include <filesystem>

namespace foam::texgen {

/// A picture from which a preset takes the sizes or colors of bubbles, or an outline.
struct SourcePicture {
    /// Four channels: red, green and blue as linear light with the primaries of sRGB, from 0 to
    /// 65535 (white), and opacity, from 0 to 65535 (opaque). Colors are straight: they are not
    /// multiplied by the opacity.
    Image<std::uint16_t> pixels;

    int width() const { return pixels.width(); }
    int height() const { return pixels.height(); }
};

/// A pixel of a source picture: its color and its opacity, which is from 0 to 1.
struct SourcePixel {
    LinearRgb color;
    double opacity = 1.0;
};

/// Returns the pixel in column x and row y; row 0 is the bottom row.
SourcePixel pixel_of(const SourcePicture& picture, int x, int y);

/// Returns the color of a pixel on white paper: transparent parts show the paper.
LinearRgb color_on_white(const SourcePixel& pixel);

/// Returns the relative luminance of a color, from 0 (black) to 1 (white), with the weights of
/// ITU-R BT.709.
double luminance_of(const LinearRgb& color);

/// The pixels in the columns [left, right) and the rows [bottom, top) of a picture.
struct PixelRect {
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;
};

/// Returns the mean of number(pixel) over the pixels of `box`. Precondition: the picture has these
/// pixels, and there is at least one.
template <class Number>
double mean_over(const SourcePicture& picture, const PixelRect& box, const Number& number) {
    double sum = 0.0;
    for (int y = box.bottom; y < box.top; ++y) {
        for (int x = box.left; x < box.right; ++x) {
            sum += number(pixel_of(picture, x, y));
        }
    }
    return sum / (static_cast<double>(box.right - box.left) * (box.top - box.bottom));
}

/// Converts a picture to a source picture. Codes (SampleType) count as straight sRGB colors, other
/// numbers as linear light that is premultiplied by the opacity. A picture without the channels R,
/// G and B is gray (channel Y); a picture without a channel of opacity is opaque. Light is clamped
/// to the range from 0 to 1. `path` is the name of the file in messages. Throws InputError if the
/// picture has neither the channel Y nor the channels R, G and B. Throws OutOfMemory if the machine
/// has too little memory for the copy. Precondition: colors have the primaries of sRGB.
SourcePicture source_picture_of(const Picture& picture, const std::filesystem::path& path);

}  // namespace foam::texgen
