#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Regular hexagons of area 1 on a torus of columns x rows bubbles: a foam in equilibrium, with
/// equal pressures and straight films of energy T sqrt(2 sqrt(3)) per bubble. Throws
/// std::invalid_argument unless columns > 0 and rows is positive and even.
Foam honeycomb(int columns, int rows);

}  // namespace foam
