// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the junction is tangled: its films leave it in another cyclic order than in the
/// network, or one of its films has no length. A film leaves in the direction of its chord, an
/// outer film in the direction of the tangent to its arc. Bubbles at a tangled junction overlap or
/// are inverted.
bool is_tangled(const Foam& foam, JunctionId junction);

/// Untangles the foam by Tutte's barycentric embedding (How to draw a graph, 1963), applied
/// locally: repeatedly moves the tangled junctions, and the junctions up to two films away, to the
/// mean of their neighbors. If every junction is at the mean of its neighbors, each bubble is a
/// convex polygon, whatever the positions were before. In a patch the junctions at the ghost are
/// not moved, since otherwise the patch would shrink to a point. Areas are not kept; relaxation
/// restores them. Returns the number of junctions that were tangled. If there are none, nothing is
/// moved.
int untangle(Foam& foam);

}  // namespace foam
