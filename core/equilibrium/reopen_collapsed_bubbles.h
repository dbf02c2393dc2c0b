// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Reopens collapsed bubbles: two-sided bubbles that have less than a hundredth of their target
/// area. Bubbles at the surface of a patch, and bubbles whose two ends share their third film, are
/// not reopened. Returns the number of reopened bubbles.
///
/// Relaxation cannot open such a bubble. Its two films pull its ends together, and pushing the ends
/// apart takes a pressure of sqrt(3) film tensions divided by their distance, which grows as the
/// distance shrinks. Therefore the ends are moved apart directly, each along the third film at its
/// junction. An end moves by up to a third of that film, and by at most half the distance of the
/// ends in equilibrium. The bubble gets the pressure at which its films meet at 120 degrees.
int reopen_collapsed_bubbles(Foam& foam);

}  // namespace foam
