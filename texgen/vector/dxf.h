// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/drawing.h"

#include <string>

namespace foam::texgen {

/// Returns the layers of a drawing with Layer::is_tool_path (lines and walls) as DXF of AutoCAD
/// 2000 (AC1015), for plotters, laser cutters and CAD. The unit is the millimeter. Every chain of
/// arcs (Chain) becomes one LWPOLYLINE, a polyline that gives each arc as a number called its
/// bulge. Every junction is a POINT on the layer "junctions". All other layers are left out: the
/// filled bubbles, the ground under mazes and contours, and the parts of lines beyond the border of
/// the tile (Layer::is_beyond_tile). A cutter would follow their arcs a second time.
std::string to_dxf(const Drawing& drawing);

}  // namespace foam::texgen
