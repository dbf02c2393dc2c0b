// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Returns a foam of columns x rows regular hexagons of area 1 on a torus. The foam is in
/// equilibrium: all pressures are 0 and the films are straight. Its energy per bubble is
/// T sqrt(2 sqrt(3)), with the film tension T. Throws std::invalid_argument unless columns > 0 and
/// rows is positive and even.
Foam honeycomb(int columns, int rows);

}  // namespace foam
