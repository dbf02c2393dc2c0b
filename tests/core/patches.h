// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam::test {

/// Returns two bubbles that share one film, far from equilibrium. Bubble 0 is on the left. The
/// arguments are target areas.
Foam double_bubble(double left_area, double right_area);

/// Returns three bubbles around a junction. Each touches the other two and the ghost. `area` is
/// their target area.
Foam triple_bubble(double area);

/// Returns bubble 0, which has six sides, with six bubbles around it (petals). `area` is the target
/// area of all bubbles.
Foam flower(double area);

/// Returns four bubbles of target area 1 in a row, numbered from left to right.
Foam chain();

/// Returns six bubbles of target area 1 around a hole.
Foam ring();

}  // namespace foam::test
