#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Whether the films leave a junction in another order around it, by their chords or, of outer
/// films, their arcs, than the network says, or one of them has no length: then its bubbles
/// overlap, or are turned inside out.
bool is_tangled(const Foam& foam, JunctionId junction);

/// Takes tangles apart: the junctions within two films of each tangled one move to the mean of
/// their neighbours, again and again. Where every junction is at that mean, each bubble is a convex
/// polygon, whatever the positions were (Tutte, How to draw a graph, 1963). In a patch the
/// junctions at the ghost stay, else all would shrink to a point. Areas are for relaxation to
/// restore. Returns the number of tangled junctions; leaves a foam without any as it is.
int untangle(Foam& foam);

}  // namespace foam
