// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

namespace foam::texgen {

inline constexpr EventTraits kCollapseEvent = {
    .name = "collapse",
    .meaning =
        "bubbles shrink and vanish, `at-once` or `in-turn`; the others take up their gas in "
        "proportion to their areas",
    .takes_bubbles = true,
    .takes_position = true,
    .takes_count = true};

/// Selects whether the bubbles of one event collapse together or one after the other.
enum class EventOrder { AtOnce, InTurn };

struct CollapseOptions {
    EventOrder order = EventOrder::AtOnce;
};

Keys<CollapseOptions> collapse_keys();
void check_collapse(const EventCheck& check, const CollapseOptions& options);

/// Drives the chosen bubbles to the T2 area. They vanish at their last frame.
void advance_collapse(const EventBase& event, const CollapseOptions& options, EventStage& stage);

}  // namespace foam::texgen
