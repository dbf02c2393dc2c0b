// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the junction is tangled. The junction is tangled if its films leave in a cyclic
/// order that differs from their order in the network. It is also tangled if the chord of one of
/// these films is zero (shorter than 1e-9 foam units). The direction in which an inner film leaves
/// is the direction of its chord; for an outer film it is the tangent to its arc. Bubbles at a
/// tangled junction overlap or are inverted.
bool is_tangled(const Foam& foam, JunctionId junction);

/// Untangles the foam by Tutte's barycentric embedding (How to draw a graph, 1963), applied
/// locally. Repeatedly moves each tangled junction, and each junction up to two films away, to the
/// mean of its neighbors. If every junction of a torus, or every junction inside a fixed convex
/// outline, is at the mean of its neighbors, each bubble is a convex polygon, whatever the
/// positions were before. In a patch the junctions at the ghost are not moved, since otherwise the
/// patch would shrink to a point. Areas are not kept; relaxation restores them. Returns the number
/// of junctions that were tangled before. If no junction is tangled, no junction is moved.
int untangle(Foam& foam);

}  // namespace foam
