// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/drawing.h"

#include <string>

namespace foam::texgen {

/// Returns a drawing as a PDF of one page, written by cairo. PDF has no arcs, so cubic Bezier
/// curves replace them. Each curve turns by at most 30 degrees and differs from the arc by less
/// than 4e-7 of its radius. Cairo rounds coordinates to 1/256 point (0.0014 mm). Throws
/// std::bad_alloc if cairo has too little memory, std::runtime_error for other errors of cairo, and
/// std::invalid_argument if a color is not "#rrggbb".
std::string to_pdf(const Drawing& drawing);

}  // namespace foam::texgen
