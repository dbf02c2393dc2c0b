// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/preset/loop.h"

namespace foam::texgen {

/// Returns true if `transformed_for_display` changes the foam: if the loop has a drift, or is a
/// shear loop.
bool has_display_transform(const LoopOptions& loop);

/// Returns the foam as images show it after the fraction `progress` of the loop, from 0 to 1. The
/// displacement by a current (class Current) is not included; it is applied elsewhere. The foam is
/// displaced by the fraction `progress` of the drift. In a shear loop the shear is removed, so that
/// images tile. Removing the shear moves the junctions but keeps the pressures, so that films keep
/// their curvatures. Angles between films change by up to about the strain, in radians.
Foam transformed_for_display(Foam foam, const LoopOptions& loop, double progress);

/// Returns the displacement by the drift of the loop, in foam units, after the fraction `progress`
/// of the loop.
Vec2 drift_displacement(const Domain& domain, const LoopOptions& loop, double progress);

/// Returns the position to which `transformed_for_display` moves a point of the foam. `domain` is
/// the domain before the shear is removed.
Vec2 transformed_for_display(const Vec2& point,
                             const Domain& domain,
                             const LoopOptions& loop,
                             double progress);

}  // namespace foam::texgen
