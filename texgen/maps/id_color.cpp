// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/id_color.h"

#include "core/geometry/elementary.h"
#include "texgen/image/oklab.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/identity_number.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// Every hue with these lightnesses and this chroma is within sRGB.
constexpr double kDarkest = 0.59;
constexpr double kLightest = 0.80;
constexpr double kChroma = 0.10;

}  // namespace

LinearRgb identity_color(BubbleIdentity identity) {
    const double hue = 2.0 * std::numbers::pi * identity_number(identity, IdentityStream::First);
    const double lightness =
        std::lerp(kDarkest, kLightest, identity_number(identity, IdentityStream::Second));
    const auto [sine, cosine] = ieee::sincos(hue);
    return to_linear(Oklab{lightness, kChroma * cosine, kChroma * sine});
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
