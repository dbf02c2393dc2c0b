// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/display_transform.h"

#include "core/dynamics/shear.h"

namespace foam::texgen {

Vec2 drift_displacement(const Domain& domain, const LoopOptions& loop, double progress) {
    return {progress * loop.drift[0] * domain.width, progress * loop.drift[1] * domain.height};
}

bool has_display_transform(const LoopOptions& loop) {
    return loop.kind == LoopKind::Shear || loop.drift != std::array{0, 0};
}

Foam transformed_for_display(Foam foam, const LoopOptions& loop, double progress) {
    if (loop.kind == LoopKind::Shear) {
        shear(foam, -foam.domain.shear / foam.domain.height);
        foam.domain.shear = 0.0;  // shear() leaves a rounding error
    }
    if (loop.drift != std::array{0, 0}) {
        translate(foam, drift_displacement(foam.domain, loop, progress));
    }
    return foam;
}

Vec2 transformed_for_display(const Vec2& point,
                             const Domain& domain,
                             const LoopOptions& loop,
                             double progress) {
    const double sheared =
        loop.kind == LoopKind::Shear ? domain.shear * point.y() / domain.height : 0.0;
    return point - Vec2(sheared, 0.0) + drift_displacement(domain, loop, progress);
}

}  // namespace foam::texgen
