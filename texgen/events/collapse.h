// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"

namespace foam::texgen {

inline constexpr EventTraits kCollapseEvent = {
    .name = "collapse",
    .meaning =
        "bubbles shrink and vanish, `at-once` or `in-turn`; on a torus the gas goes to the other "
        "bubbles in proportion to their areas, in a patch it goes to the surroundings",
    .takes_bubbles = true,
    .takes_position = true,
    .takes_count = true};

/// Selects whether the bubbles of one event collapse together or one after the other.
enum class EventOrder { AtOnce, InTurn };

struct CollapseOptions {
    EventOrder order = EventOrder::AtOnce;
};

Keys<CollapseOptions> collapse_keys();

/// Rejects an event without a valid choice of bubbles (check_choice), and an event whose bubbles
/// collapse in turn but which has fewer frames than bubbles.
void check_collapse(const EventCheck& check, const CollapseOptions& options);

/// Schedules the collapse of the bubbles that begin to collapse in the step that leads to the frame
/// `context.frame`. Their target areas shrink to the T2 area, and the bubbles vanish at the last
/// frame of their collapse. With EventOrder::AtOnce, this is the last frame of the event. Adds the
/// number of bubbles that do not exist to context.missing.
void advance_collapse(const EventBase& event,
                      const CollapseOptions& options,
                      EventContext& context);

}  // namespace foam::texgen
