// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <vector>

namespace foam::test {

/// Two bubbles beside each other, far from equilibrium.
Foam double_bubble(double left_area, double right_area);

/// Three bubbles around a junction, each in touch with the other two and the ghost.
Foam triple_bubble(double area);

/// A bubble of six sides with six around it, all of the same area.
Foam flower(double area);

/// Four bubbles of area 1 in a row.
Foam chain();

/// Six bubbles of area 1 around a hole.
Foam ring();

}  // namespace foam::test
