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

/// The last frame that an event may name.
inline constexpr int kLastEventFrame = 100'000;

/// The frames of an event: it begins on the way to the first, and is complete at the last.
struct FrameSpan {
    int first = 0;  // 0 if unset
    int last = 0;

    int length() const { return last - first + 1; }
    friend bool operator==(const FrameSpan& a, const FrameSpan& b) = default;
};

/// Divides the frames into parts, as equal as possible, and returns one of them.
FrameSpan part_of(const FrameSpan& frames, std::size_t index, std::size_t parts);

/// The properties that events of all kinds share.
struct EventBase {
    std::string kind;                           // empty if unset
    FrameSpan frames;                           // or else `time`
    std::optional<std::array<double, 2>> time;  // foam time from and to; both equal for an instant

    // The bubbles, by one of three; a position is in fractions of the image's width and height.
    std::vector<BubbleIdentity> bubbles;
    std::optional<std::array<double, 2>> at;
    std::vector<int> sides;
    int count = 1;

    /// Returns the number of bubbles that the event names; 0 stands for all.
    std::size_t bubbles_named() const;
};

/// The properties of a kind of event, and which of the shared keys it takes.
struct EventTraits {
    std::string_view name;        // as in `kind = "collapse"`
    std::string_view meaning;     // in Markdown
    bool takes_bubbles = false;   // bubble and sides
    bool takes_position = false;  // at
    bool takes_count = false;     // count
};

/// Returns the keys that say when an event happens: frame, frames and time.
Keys<EventBase> time_keys();

/// Returns the keys that choose bubbles or a position, each for the kinds that take it.
Keys<EventBase> choice_keys(const std::vector<EventTraits>& kinds);

}  // namespace foam::texgen
