// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A value for every bubble of a frame. The values of the bubbles of the network come first, in the
/// order of their ids. The values of the lone bubbles follow, in the order of Frame::lone_bubbles.
template <class Value>
using PerBubble = std::vector<Value>;

/// Returns the result of value_of(id) for every bubble of the network, then the result of
/// value_of_lone(bubble) for every lone bubble.
template <class Value, class ValueOf, class ValueOfLone>
PerBubble<Value> per_bubble(const Frame& frame,
                            const ValueOf& value_of,
                            const ValueOfLone& value_of_lone) {
    PerBubble<Value> values;
    values.reserve(frame.bubbles.size() + frame.lone_bubbles.size());
    for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
        values.push_back(value_of(id_at<BubbleId>(k)));
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        values.push_back(value_of_lone(bubble));
    }
    return values;
}

/// Returns a table of values indexed by the ids of a DistanceField. The values of the bubbles of
/// the network come first. In a patch they are followed by `around`, the value of the surroundings,
/// and by the values of the lone bubbles.
template <class Value>
std::vector<Value> by_cell_id(const Frame& frame, PerBubble<Value> values, Value around) {
    if (frame.domain.is_plane()) {
        const auto bubbles = static_cast<std::ptrdiff_t>(frame.bubbles.size());
        values.insert(values.begin() + bubbles, around);
    }
    return values;
}

/// Returns the identities of all bubbles.
inline PerBubble<BubbleIdentity> identities_of(const Frame& frame) {
    return per_bubble<BubbleIdentity>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].identity; },
        [](const LoneBubble& bubble) { return bubble.identity; });
}

}  // namespace foam::texgen
