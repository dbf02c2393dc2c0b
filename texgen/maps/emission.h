// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/glow.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kEmissionMap = {.name = "emission",
                                           .meaning = "light that the surface emits (key lit.glow)",
                                           .unit = "light",
                                           .channels = "R G B",
                                           .kind = MapKind::Color,
                                           .png_filter = PngFilter::Up,
                                           .smooth_images = SmoothImages::DistanceAndGradient};

/// Draws the emitted light of a surface: its colors, multiplied by the result of glow_fractions.
/// The map `lit` shows the same light. The surroundings of a patch are transparent. Throws as
/// draw_surface_colors does.
ColorPixels draw_emission(FrameLayers& layers, const SurfaceColors& surface, double glow);

}  // namespace foam::texgen
