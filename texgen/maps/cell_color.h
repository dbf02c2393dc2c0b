#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/cell_fill.h"

#include <vector>

namespace foam::texgen {

/// Where every bubble of a frame stands on the scale of options.color_by, 0 to 1.
PerBubble<double> tones_of(const Frame& frame, const AlbedoOptions& options);

/// The colour of every bubble: of its tone, and lighter or darker by the bubble's own part of
/// options.variation, which it has for life. Throws std::invalid_argument for a colour map or a
/// colour that is not known, and unless pressure_low < pressure_high.
PerBubble<LinearRgb> cell_colors(const Frame& frame, const AlbedoOptions& options);

}  // namespace foam::texgen
