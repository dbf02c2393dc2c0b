// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Reopens collapsed bubbles: two-sided bubbles that have less than a hundredth of their target
/// area. Leaves two kinds of collapsed bubbles as they are: bubbles with an outer film, and bubbles
/// whose two ends are also joined by a third film. Returns the number of reopened bubbles.
///
/// Relaxation cannot open a collapsed bubble. Its two films pull its ends together. To push the
/// ends apart, the pressure in the bubble must exceed the pressure around it by sqrt(3) T / d. Here
/// T is the film tension, and d is the distance between the ends. This excess grows without bound
/// as the distance shrinks. Therefore the ends, which are junctions, are moved apart directly, each
/// along the one film at this end that does not bound the bubble. An end moves by a third of the
/// chord length of this film, but by at most half the distance that the two ends have in
/// equilibrium. The bubble gets the pressure at which its films meet at 120 degrees.
int reopen_collapsed_bubbles(Foam& foam);

}  // namespace foam
