// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A bubble that an event acts on; it may be a lone bubble.
struct ChosenBubble {
    BubbleIdentity bubble = 0;
    double area = 0.0;  // target area, foam units
};

/// Returns up to `count` of the bubbles that an event names, or all bubbles of the foam if `count`
/// is 0. `turn` is the number of bubbles that earlier calls have chosen; a list of identities or of
/// numbers of sides continues at this index. Returns fewer bubbles, or none, if they do not exist.
std::vector<ChosenBubble> choose_bubbles(const EventBase& event,
                                         const EventStage& stage,
                                         std::size_t turn,
                                         std::size_t count);

/// Rejects an event that has more than one of the keys bubble, at and sides, which choose bubbles.
/// Rejects an event that has none of them, unless `may_choose_all` is true. Rejects a count without
/// sides.
void check_choice(const EventCheck& check, bool may_choose_all);

}  // namespace foam::texgen
