// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"
#include "texgen/maps/occlusion.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/thin_film.h"

namespace foam::texgen {

inline constexpr MapTraits kLitMap = {
    .name = "lit",
    .meaning = "albedo or thin_film, shaded by a light on the relief",
    .unit = "light",
    .channels = "R G B",
    .png_filter = PngFilter::Up};

/// The map that is lit.
enum class LitColors { Albedo, ThinFilm };

/// A distant light, and how the surface reflects it. The viewer is straight above the foam.
struct LitOptions {
    LitColors colors = LitColors::Albedo;
    double azimuth = 135.0;   // direction of the light: degrees from the right, counterclockwise
    double elevation = 50.0;  // height of the light: degrees above the plane
    double ambient = 0.4;     // fraction of the light that comes from a uniform sky
    double gloss = 0.25;      // brightness of highlights
    double shininess = 40.0;  // exponent of highlights; larger values make them smaller
    double rim = 0.0;         // brightness added to steep slopes, such as the rims of bubbles
    double glow = 0.0;        // fraction of the color of films and shades that is emitted light
    int samples = 2;          // samples per pixel in each direction; their mean is drawn
};

Keys<LitOptions> lit_keys();

/// The options of the maps that are lit.
struct LitSurface {
    const AlbedoOptions& albedo;
    const ThinFilmOptions& thin_film;
    const ReliefOptions& relief;
    const OcclusionOptions& occlusion;
};

/// Draws the colors of the foam on its relief, lit by a distant light. Flat ground keeps its color.
/// Highlights follow J. F. Blinn, "Models of light reflection for computer synthesized pictures"
/// (1977). The visible sky is computed by draw_occlusion. The surroundings of a patch are
/// transparent.
ColorPixels draw_lit(FrameLayers& layers, const LitOptions& options, const LitSurface& surface);

}  // namespace foam::texgen
