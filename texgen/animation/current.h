// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/animation/periodic_waves.h"
#include "texgen/preset/loop.h"

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// A current on a torus, which carries the drawn foam around and back in every loop. At each moment
/// of the loop, a stream function, the sum of a few waves, gives a velocity field. The displacement
/// at this moment is computed from this field alone. A point follows the field, as if it did not
/// change, for one unit of an auxiliary time, and is drawn where it arrives. In the course of the
/// loop, each wave travels by one wavelength; in a pingpong, it travels by half a wavelength and
/// back. The displacement at the end of the loop therefore equals the displacement at its start.
/// The displacement has no seam, maps the torus to itself one to one and preserves areas. The paths
/// of points are integrated numerically. For the strengths that the key loop.current allows, this
/// changes areas by less than 1e-5 of their values.
class Current {
  public:
    /// Uses the options `current` and `eddies` of the loop. `aspect` is the width of the torus
    /// divided by its height. `seed` determines the directions and the phases of the waves.
    Current(const LoopOptions& loop, double aspect, std::uint64_t seed);

    /// Returns the displacement of a point of the foam at the fraction `progress` of the loop.
    Vec2 displacement(const Vec2& point, const Domain& domain, double progress) const;

    /// Returns the frame, displaced by the current at the fraction `progress` of the loop
    /// (displaced_frame.h). Precondition: the frame is on a torus.
    Frame carried(const Frame& frame, double progress) const;

  private:
    double strength_;
    std::vector<PeriodicWave> waves_;
    std::vector<int> directions_;  // direction of travel of each wave: 1 or -1
};

}  // namespace foam::texgen
