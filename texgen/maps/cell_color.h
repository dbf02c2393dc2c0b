#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"

#include <vector>

namespace foam::texgen {

/// Returns the position of every bubble on the scale of options.color_by, 0 to 1.
PerBubble<double> tones_of(const Frame& frame, const AlbedoOptions& options);

/// Returns the color of every bubble: that of its tone, lighter or darker by the bubble's own share
/// of options.variation, which it keeps for life. Throws std::invalid_argument for an unknown color
/// map or color, and unless pressure_low < pressure_high.
PerBubble<LinearRgb> cell_colors(const Frame& frame, const AlbedoOptions& options);

}  // namespace foam::texgen
