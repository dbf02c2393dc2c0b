// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/collapse.h"

#include "texgen/events/chosen_bubbles.h"
#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

namespace foam::texgen {

Keys<CollapseOptions> collapse_keys() {
    constexpr Choices<EventOrder> kOrders = {
        {{{"at-once", EventOrder::AtOnce}, {"in-turn", EventOrder::InTurn}}}};
    return {key("order",
                kOrders,
                "several bubbles collapse at the same time, or one after the other, each in an "
                "equal part of the frames (rounded to whole frames)",
                &CollapseOptions::order)};
}

void check_collapse(const EventCheck& check, const CollapseOptions& options) {
    check_choice(check, false);
    const std::size_t bubbles = check.event.chosen_count();
    const auto frames = static_cast<std::size_t>(check.frames.length());
    check.require(
        options.order == EventOrder::AtOnce || bubbles <= frames,
        "order",
        fmt::format(
            "{} bubbles that collapse in turn need at least as many frames; the event has {}",
            bubbles,
            frames));
}

void advance_collapse(const EventBase& event,
                      const CollapseOptions& options,
                      EventContext& context) {
    const std::size_t count = event.chosen_count();
    const std::size_t parts = options.order == EventOrder::InTurn ? count : 1;
    for (std::size_t part = 0; part < parts; ++part) {
        const FrameSpan frames = part_of(event.frames, part, parts);
        if (frames.first != context.frame) {
            continue;
        }
        const std::vector<ChosenBubble> chosen =
            choose_bubbles(event, context, part, count / parts);
        context.missing += static_cast<int>(count / parts - chosen.size());
        for (const ChosenBubble& one : chosen) {
            const TargetAreaSchedule schedule{.from = one.area, .to = context.t2_area};
            context.schedules[one.bubble] = {frames, schedule, true};
        }
    }
}

}  // namespace foam::texgen
