// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kThinFilmMap = {
    .name = "thin_film",
    .meaning = "interference colors of a soap film across every bubble",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::DistanceAndGradient};

/// The soap film that spans each bubble. It is not the film between two bubbles.
struct ThinFilmOptions {
    double thickness = 350.0;  // nanometers, in the middle of a bubble; the mean over all bubbles
    double variation = 0.6;    // width of the range of thicknesses among bubbles, as a fraction of
                               // `thickness`; a bubble keeps its thickness for life
    double drainage = 0.5;     // added thickness at the bubble's rim, where liquid gathers, as a
                               // fraction of the thickness in the middle
    double gravity = 0.0;      // added thickness at the bottom of a bubble, and removed thickness
                               // at its top, as a fraction of the thickness in the middle
    double swirl = 0.0;        // amplitude of swirls in the thickness, as a fraction of the
                               // thickness in the middle; each bubble has swirls of its own
    double exposure = 8.0;     // factor on the reflected light; a soap film reflects at most 8 % of
                               // the incident light
};

Keys<ThinFilmOptions> thin_film_keys();

/// Draws bubbles in the interference colors of a soap film that spans each bubble. The films
/// between bubbles have the color, width and shape that the options of albedo give. The thickness
/// depends only on the bubble and on the position in the bubble, so colors do not move while the
/// foam is at rest. Colors outside sRGB are mixed with gray of the same luminance until they are
/// within sRGB. The surroundings of a patch are transparent.
ColorPixels draw_thin_film(FrameLayers& layers,
                           const ThinFilmOptions& options,
                           const AlbedoOptions& albedo);

}  // namespace foam::texgen
