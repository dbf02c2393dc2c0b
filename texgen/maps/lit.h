// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/glow.h"
#include "texgen/maps/lighting.h"
#include "texgen/maps/map.h"
#include "texgen/maps/occlusion.h"
#include "texgen/maps/relief.h"
#include "texgen/maps/thin_film.h"

namespace foam::texgen {

inline constexpr MapTraits kLitMap = {
    .name = "lit",
    .meaning = "albedo, thin_film or maze, shaded by a light on the relief",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::DistanceAndGradient,
    .shows_relief = true};

struct LitOptions {
    LitColors colors = LitColors::Albedo;
    LightOptions light{};
    // Films, the shade beside films, and the walls of a maze emit this fraction of their color as
    // light (glow_fractions).
    double glow = 0.0;
    // The number of points in each direction over which a pixel shows the mean light, if the light
    // varies strongly there: at creases, in small highlights and at the borders of reflected
    // windows. Any other pixel shows the light at its center.
    int samples = 3;
};

Keys<LitOptions> lit_keys();

/// The options of the colors and of the relief that are lit. Borrows them.
struct LitSurface {
    const AlbedoOptions& albedo;
    const ThinFilmOptions& thin_film;
    ReliefSource relief;
    const OcclusionOptions& occlusion;
};

/// Draws the colors of the foam on its relief, lit by a distant light. Flat ground keeps its color
/// if the whole sky is visible from it. Highlights follow J. F. Blinn, "Models of light reflection
/// for computer synthesized pictures" (1977); reflections of windows and of the horizon follow
/// J. F. Blinn and M. E. Newell, "Texture and reflection in computer generated images" (1976). The
/// visible fraction of the sky is computed as for the map `occlusion` (occlusion_of). The
/// surroundings of a patch are transparent. Throws as draw_surface_colors does.
ColorPixels draw_lit(FrameLayers& layers, const LitOptions& options, const LitSurface& source);

}  // namespace foam::texgen
