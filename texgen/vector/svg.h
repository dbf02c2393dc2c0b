// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/drawing.h"

#include <string>

namespace foam::texgen {

/// Returns a drawing as SVG 1.1. Its size is in millimeters; a unit of the coordinates is a
/// millimeter. Arcs are written with the path command A. Layers are groups that Inkscape shows as
/// layers.
std::string to_svg(const Drawing& drawing);

}  // namespace foam::texgen
