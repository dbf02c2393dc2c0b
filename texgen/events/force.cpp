// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/force.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

namespace foam::texgen {

Keys<ForceOptions> force_keys() {
    return {key("radius",
                Reals{0.1, 500.0},
                "radius of the region that is pushed, in foam units; at most half of the shorter "
                "side of a torus",
                &ForceOptions::radius)
                .in("foam units"),
            key("push",
                Points{{-100.0, 100.0}},
                "total displacement of the center of the region, in foam units; then the foam "
                "relaxes, so that only swaps of neighbors remain",
                &ForceOptions::push)
                .in("foam units")};
}

void check_force(const EventCheck& check, const ForceOptions& options) {
    check.require(check.event.at.has_value(),
                  "kind",
                  "the event must have the key 'at', the position of the push");
    const double largest = 0.5 * check.setting.shorter_side;
    check.require_fit(
        check.setting.is_patch || options.radius <= largest,
        "radius",
        " ",
        fmt::format("must be at most {:.3g}, half of the shorter side of the torus", largest));
}

void advance_force(const EventBase& event, const ForceOptions& options, EventContext& context) {
    const double part = 1.0 / event.frames.length();
    const Vec2 push = part * Vec2(options.push[0], options.push[1]);
    const Vec2 center = context.point_at(*event.at) + (context.frame - event.frames.first) * push;
    context.change.pushes.push_back({center, options.radius, push});
}

}  // namespace foam::texgen
