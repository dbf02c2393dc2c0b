// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/nucleate.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

namespace foam::texgen {

Keys<NucleateOptions> nucleate_keys() {
    using Options = NucleateOptions;
    constexpr Choices<NucleationSite> kSites = {
        {{{"junction", NucleationSite::Junction}, {"film", NucleationSite::Film}}}};
    return {key("on",
                kSites,
                "where a new bubble appears: at a junction (the bubble has three sides) or on a "
                "film (two sides)",
                &Options::on),
            key("area",
                Reals{0.0002, 100.0},
                "target area of a new bubble, in square foam units; must be above dynamics.t2_area",
                &Options::area)
                .in("square foam units"),
            key("growth",
                Integers{1, kLastEventFrame},
                "number of frames in which a new bubble grows to its area; if the event creates "
                "several bubbles, their births are spread evenly over its frames",
                &Options::growth)
                .in("frames")};
}

void check_nucleate(const EventCheck& check, const NucleateOptions& options) {
    const double t2_area = check.setting.t2_area;
    check.require_fit(options.area > t2_area,
                      "area",
                      fmt::format(" = {} ", options.area),
                      fmt::format("must be above dynamics.t2_area = {}", t2_area));
    check.require(!check.event.at || check.event.count == 1,
                  "count",
                  "must be 1 if the event has a position (the key 'at')");
}

void advance_nucleate(const EventBase& event,
                      const NucleateOptions& options,
                      EventContext& context) {
    const double first = first_area(options.area, context.t2_area);
    const auto count = static_cast<std::size_t>(event.count);
    for (std::size_t k = 0; k < count; ++k) {
        if (part_of(event.frames, k, count).first != context.frame) {
            continue;
        }
        const std::optional<BubbleId> bubble =
            event.at ? nucleate_near(options.on, context.point_at(*event.at), first, context.foam)
                     : nucleate_anywhere(options.on, first, context.random, context.foam);
        if (bubble) {
            const FrameSpan frames{context.frame, context.frame + options.growth - 1};
            grow_bubble(context.foam, *bubble, frames, options.area, context.schedules);
        } else {
            ++context.missing;
        }
    }
}

}  // namespace foam::texgen
