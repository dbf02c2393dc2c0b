// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// MapTraits::smooth_images is left None, because draw_caustics computes a distance field of
/// its own. This field has one pixel per ray of light, and a pixel of the image may have several
/// rays.
inline constexpr MapTraits kCausticsMap = {
    .name = "caustics",
    .meaning = "light on the floor of a pool whose water surface is the relief",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .png_filter = PngFilter::Up,
    .shows_relief = true};

/// The water, and the colors in which the map shows the light on the floor.
struct CausticsOptions {
    double depth = 1.0;  // depth of the water, in bubble diameters (ReliefOptions::mean_bubble)
    // The brightness is 1 - exp(-exposure * light). Under flat water, the light is 1.
    double exposure = 0.7;
    // The colors (sRGB) of the brightnesses from 0 to 1, evenly spaced. An empty list stands for
    // these default colors.
    std::vector<std::string> colors = {"#04465c", "#0d7d96", "#59c9d2", "#d9fbf4", "#ffffff"};
    // Rays per pixel in each direction. Fewer are used if a row or a column of the image would
    // otherwise have more than kMaxGridSide rays.
    int samples = 3;
};

Keys<CausticsOptions> caustics_keys();

/// Draws the light on the floor of a pool under a sun straight above. The relief is the surface of
/// the water. The water refracts the light by Snell's law for small angles: a ray moves uphill by
///     depth * (1 - 1/1.33) * slope.
/// Where rays meet, the floor is bright. Light that leaves one side of a torus enters at the
/// opposite side. Rays that leave the image of a patch are lost, and no light enters it from
/// outside. The surroundings of a patch are transparent. Throws std::invalid_argument if a color is
/// invalid.
ColorPixels draw_caustics(FrameLayers& layers,
                          const ReliefSource& source,
                          const CausticsOptions& options);

}  // namespace foam::texgen
