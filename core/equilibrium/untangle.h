#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns true if the films leave the junction in another order around it than the network has, by
/// the directions of their chords or, for outer films, their arcs, or if a film has no length. Then
/// its bubbles overlap, or are inverted.
bool is_tangled(const Foam& foam, JunctionId junction);

/// Untangles the foam: repeatedly moves the junctions within two films of each tangled one to the
/// mean of their neighbors. If every junction is at that mean, each bubble is a convex polygon,
/// whatever the positions were (Tutte, How to draw a graph, 1963). In a patch the junctions at the
/// ghost stay, since otherwise all would shrink to a point. Relaxation is left to restore the
/// areas. Returns the number of tangled junctions; a foam without any stays as it is.
int untangle(Foam& foam);

}  // namespace foam
