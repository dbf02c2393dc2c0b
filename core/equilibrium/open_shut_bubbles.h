#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Opens the bubbles of two sides that are shut: those with less than a hundredth of their target
/// area. Returns their number; a foam without any stays as it is.
///
/// Relaxation cannot open such a bubble. Its two films pull its ends together, and it takes a
/// pressure of sqrt(3) film tensions over their distance to push them apart: the more, the smaller
/// the distance has become. So the ends are moved apart, each along the third film there, by up to
/// a third of that film, but not beyond the distance in equilibrium. The bubble gets the pressure
/// of films that meet at 120 degrees. Bubbles at the surface of a patch are left out.
int open_shut_bubbles(Foam& foam);

}  // namespace foam
