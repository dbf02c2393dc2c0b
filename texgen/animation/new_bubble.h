#pragma once

#include "core/foam/foam.h"
#include "core/foam/random.h"
#include "texgen/preset/event.h"

#include <optional>

namespace foam::texgen {

/// A new bubble of a target area, above 0, on the junction or film nearest to a place. Nothing, and
/// no change, outside of a patch and where there is too little gas (nucleation.h).
std::optional<BubbleId> nucleate_near(NucleationSite on,
                                      const Vec2& place,
                                      double area,
                                      Foam& foam);

/// The same near a random place of a torus, or of the box around a patch: the first of up to 100
/// at which one can be.
std::optional<BubbleId> nucleate_anywhere(NucleationSite on,
                                          double area,
                                          Random& random,
                                          Foam& foam);

}  // namespace foam::texgen
