// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/outline.h"
#include "core/foam/patch_options.h"

#include <span>

namespace foam {

/// Returns the Voronoi diagram of random sites within an outline as a patch that is not in
/// equilibrium. Cells are clipped to the outline, and small cells are then merged with their
/// neighbors. Corners of the outline that do not become junctions are dropped (polygon_mesh.h). The
/// patch is scaled to a mean cell area of 1, and the mean of the corners of all cells is moved to
/// the origin. Throws std::invalid_argument if an option is out of range or the outline has no
/// area. Throws std::runtime_error if none of several random draws gives a valid foam, for example
/// if the outline is too narrow for its bubbles.
Foam seed_patch(const Outline& outline, const PatchOptions& options);

/// Returns a patch that is seeded in an outline of several parts, which do not overlap. Each part
/// becomes a raft of its own. Its share of the bubbles is proportional to its area or, if there is
/// an area field, to the integral of 1 / field over the part. A part with a share of less than one
/// and a half bubbles becomes a lone bubble. Throws as the function above; also throws
/// std::runtime_error if the share of a part is less than a tenth of a bubble.
Foam seed_patch(std::span<const Outline> parts, const PatchOptions& options);

}  // namespace foam
