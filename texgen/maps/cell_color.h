// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"

#include <vector>

namespace foam::texgen {

/// Returns the position of every bubble on the scale of options.color_by: 0 at its start, 1 at its
/// end. Pressures and numbers of sides beyond the scale have positions outside [0, 1]. Throws
/// std::invalid_argument if options.color_by is Pressure and pressure_low is not below
/// pressure_high.
PerBubble<double> tones_of(const Frame& frame, const AlbedoOptions& options);

/// Returns the color of every bubble: the color at its position on the scale, made lighter or
/// darker by at most options.variation. Each bubble keeps its own variation for life. Throws
/// std::invalid_argument for an unknown color map or an invalid color, and as tones_of does.
PerBubble<LinearRgb> cell_colors(const Frame& frame, const AlbedoOptions& options);

}  // namespace foam::texgen
