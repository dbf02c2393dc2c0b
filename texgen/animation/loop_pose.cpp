// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_pose.h"

#include "core/dynamics/shear.h"

namespace foam::texgen {

namespace {

// Returns the displacement by the drift after the fraction `passed` of the loop.
Vec2 drift_displacement(const Domain& domain, const LoopOptions& loop, double passed) {
    return {passed * loop.drift[0] * domain.width, passed * loop.drift[1] * domain.height};
}

}  // namespace

bool is_posed(const LoopOptions& loop) {
    return loop.kind == LoopKind::Shear || loop.drift != std::array{0, 0};
}

Foam posed(Foam foam, const LoopOptions& loop, double passed) {
    if (loop.kind == LoopKind::Shear) {
        shear(foam, -foam.domain.shear / foam.domain.height);
        foam.domain.shear = 0.0;  // removes the rounding error
    }
    if (loop.drift != std::array{0, 0}) {
        translate(foam, drift_displacement(foam.domain, loop, passed));
    }
    return foam;
}

Vec2 posed(const Vec2& point, const Domain& domain, const LoopOptions& loop, double passed) {
    const double sheared =
        loop.kind == LoopKind::Shear ? domain.shear * point.y() / domain.height : 0.0;
    return point - Vec2(sheared, 0.0) + drift_displacement(domain, loop, passed);
}

}  // namespace foam::texgen
