// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Reopens two-sided bubbles that have collapsed, which means that they have less than a hundredth
/// of their target area. Returns their number; a foam without any stays as it is. Bubbles at the
/// surface of a patch, and bubbles whose two ends share their third film, are left out.
///
/// Relaxation cannot open such a bubble. Its two films pull its ends together, and pushing the ends
/// apart takes a pressure of sqrt(3) film tensions divided by their distance, which grows as the
/// distance shrinks. Therefore the ends are moved apart directly, each along the third film at its
/// junction. An end moves by up to a third of that film, and by at most half the distance of the
/// ends in equilibrium. The bubble gets the pressure at which its films meet at 120 degrees.
int reopen_collapsed_bubbles(Foam& foam);

}  // namespace foam
