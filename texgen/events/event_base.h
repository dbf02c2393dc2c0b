// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/keys/key.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The largest frame number that an event may have.
inline constexpr int kLastEventFrame = 100'000;

/// The frames of an event. The event begins with the step to the first frame and is complete at the
/// last frame.
struct FrameSpan {
    int first = 0;  // 0 if unset
    int last = 0;

    int length() const { return last - first + 1; }
    friend bool operator==(const FrameSpan& a, const FrameSpan& b) = default;
};

/// Divides the frames into `parts` parts, as equal as possible, and returns the part with the given
/// index, counted from 0. A part is empty (last = first - 1) if there are more parts than frames.
FrameSpan part_of(const FrameSpan& frames, std::size_t index, std::size_t parts);

/// The properties that events of all kinds share.
struct EventBase {
    std::string kind;                           // empty if unset
    FrameSpan frames;                           // unset in a preset if `time` is set
    std::optional<std::array<double, 2>> time;  // foam time [from, to]; equal for an instant

    // At most one of the next three members is set. It chooses bubbles, or gives a position.
    std::vector<BubbleIdentity> bubbles;
    std::optional<std::array<double, 2>> at;  // fractions of the image's width and height
    std::vector<int> sides;
    int count = 1;  // number of bubbles chosen by `sides`, or of new bubbles

    /// Returns the number of bubbles that the event chooses; 0 means all bubbles.
    std::size_t bubbles_named() const;
};

/// The properties of a kind of event, and the shared keys that it accepts.
struct EventTraits {
    std::string_view name;        // as in `kind = "collapse"`
    std::string_view meaning;     // in Markdown
    bool takes_bubbles = false;   // the keys bubble and sides
    bool takes_position = false;  // the key at
    bool takes_count = false;     // the key count
};

/// Returns the keys that determine when an event happens: frame, frames and time.
Keys<EventBase> time_keys();

/// Returns the keys that choose bubbles or a position: bubble, at, sides and count. Each is
/// restricted to the kinds that accept it.
Keys<EventBase> choice_keys(const std::vector<EventTraits>& kinds);

}  // namespace foam::texgen
