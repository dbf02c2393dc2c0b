#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A bubble that an event is about; it may be a lone one.
struct ChosenBubble {
    BubbleIdentity bubble = 0;
    double area = 0.0;  // its target
};

/// Returns `count` bubbles of an event, from the one with number `turn` on, or all bubbles if
/// `count` is 0. A choice that finds no bubble returns none.
std::vector<ChosenBubble> choose_bubbles(const EventBase& event,
                                         const EventStage& stage,
                                         std::size_t turn,
                                         std::size_t count);

/// Checks that an event chooses bubbles in one way, or, if it may, not at all.
void check_choice(const EventCheck& check, bool may_choose_all);

}  // namespace foam::texgen
