// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/id_color.h"

#include "core/geometry/elementary.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/identity_number.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// With these lightnesses and this chroma, every hue is within sRGB.
constexpr double kDarkest = 0.59;
constexpr double kLightest = 0.80;
constexpr double kChroma = 0.10;

double cube(double x) {
    return x * x * x;
}

// Converts Oklab to linear sRGB (B. Ottosson, "A perceptual color space for image processing",
// 2020).
LinearRgb oklab_to_linear(double lightness, double a, double b) {
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

}  // namespace

LinearRgb identity_color(BubbleIdentity identity) {
    const double hue = 2.0 * std::numbers::pi * identity_number(identity, IdentityStream::First);
    const double lightness =
        std::lerp(kDarkest, kLightest, identity_number(identity, IdentityStream::Second));
    const auto [sine, cosine] = ieee::sincos(hue);
    return oklab_to_linear(lightness, kChroma * cosine, kChroma * sine);
}

ColorPixels draw_id_color(FrameLayers& layers) {
    const Frame& frame = layers.frame();
    const auto colors = per_bubble<LinearRgb>(
        frame,
        [&](BubbleId bubble) { return identity_color(frame.bubbles[bubble].identity); },
        [](const LoneBubble& bubble) { return identity_color(bubble.identity); });
    return fill_colors(layers, colors, {}, 0.0);
}

}  // namespace foam::texgen
