// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// Returns the frame with its junctions and the middles of its films displaced. Each film becomes
/// the arc through the new positions of its ends and its middle. The stored areas and pressures of
/// bubbles stay as they are. Precondition: the frame is on a torus.
Frame displaced(Frame frame,
                const Indexed<JunctionId, Vec2>& junction_displacements,
                const Indexed<FilmId, Vec2>& middle_displacements);

/// Returns the mean of the positions of the junctions of one lattice copy of a bubble. Which copy
/// this is, is not specified. Precondition: the frame is on a torus.
Vec2 mean_corner(const Frame& frame, BubbleId bubble);

}  // namespace foam::texgen
