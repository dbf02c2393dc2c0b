// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/drawing.h"

#include <string>

namespace foam::texgen {

/// Returns the lines and walls of a drawing as DXF of AutoCAD 2000 (AC1015), for plotters, laser
/// cutters and CAD. The unit is the millimeter. Every chain is one LWPOLYLINE whose arcs are
/// bulges, and every junction is a POINT on the layer "junctions". Only layers with
/// Layer::is_outline are written. Bubbles, passages and the parts beyond the border are left out,
/// because a cutter would follow their arcs a second time.
std::string to_dxf(const Drawing& drawing);

}  // namespace foam::texgen
