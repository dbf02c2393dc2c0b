// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A bubble that an event acts on. The bubble may be a lone bubble.
struct ChosenBubble {
    BubbleIdentity bubble = 0;
    double area = 0.0;  // target area, square foam units
};

/// Returns up to `count` of the bubbles that an event chooses, or all bubbles of the foam if
/// `count` is 0. An event may call this function several times, to choose some of its bubbles in
/// each call. `first_index` is the sum of `count` over the earlier calls. The bubbles depend on the
/// key that the event has:
///
/// - `bubble`, a list of identities: the bubbles with the identities at the indices first_index to
///   first_index + count - 1 of the list. Precondition: the list has these indices.
/// - `sides`, a list of numbers of sides: the numbers take turns, beginning at the index
///   `first_index` modulo the length of the list. Each turn considers the bubbles with this number
///   of sides that the call has not chosen yet. It chooses the one with the smallest target area.
/// - `at`, a position: the bubble that contains it.
///
/// Bubbles that do not exist are left out, so that the result may be shorter or empty.
std::vector<ChosenBubble> choose_bubbles(const EventBase& event,
                                         const EventContext& context,
                                         std::size_t first_index,
                                         std::size_t count);

/// Rejects an event that has more than one of the keys `bubble`, `at` and `sides`, which choose
/// bubbles. Unless `may_choose_all` is true, also rejects an event that has none of these keys.
/// Also rejects an event that has the key `count` without the key `sides`, and an event with an
/// identity that no bubble can have.
void check_choice(const EventCheck& check, bool may_choose_all);

}  // namespace foam::texgen
