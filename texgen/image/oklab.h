// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"

namespace foam::texgen {

/// A color in Oklab, a color space in which the distance between two colors is about proportional
/// to how different they look (B. Ottosson, "A perceptual color space for image processing", 2020).
struct Oklab {
    double lightness = 0.0;  // from 0 (black) to 1 (white)
    double a = 0.0;          // from green to red
    double b = 0.0;          // from blue to yellow

    friend bool operator==(const Oklab&, const Oklab&) = default;
};

/// Converts a color from linear sRGB. For colors far outside the gamut of sRGB, negative responses
/// of the cones of the eye are replaced by 0.
Oklab to_oklab(const LinearRgb& color);

/// Converts a color to linear sRGB. The result is not clamped.
LinearRgb to_linear(const Oklab& color);

}  // namespace foam::texgen
