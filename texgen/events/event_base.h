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

/// The frames of an event. The event begins with the step from the frame before `first` and is
/// complete at frame `last`.
struct FrameSpan {
    int first = 0;  // 0 if unset
    int last = 0;

    int length() const { return last - first + 1; }
    friend bool operator==(const FrameSpan& a, const FrameSpan& b) = default;
};

/// Divides the frames into `parts` parts of nearly equal length and returns the part with the given
/// index, counted from 0. If there are more parts than frames, some parts are empty: their `last`
/// is `first` - 1.
FrameSpan part_of(const FrameSpan& frames, std::size_t index, std::size_t parts);

/// The properties that events of all kinds share.
struct EventBase {
    std::string kind;                           // empty if unset
    FrameSpan frames;                           // in a preset, unset if `time` is set
    std::optional<std::array<double, 2>> time;  // foam time [from, to]; from = to for an instant

    // In a valid event, at most one of `bubbles`, `at` and `sides` is set, and this member chooses
    // bubbles. For some kinds, `at` is the position of a new bubble or of a push instead.
    std::vector<BubbleIdentity> bubbles;      // identities of the chosen bubbles
    std::optional<std::array<double, 2>> at;  // fractions of the image's width and height
    std::vector<int> sides;  // chooses the smallest bubbles with these numbers of sides
    int count = 1;           // number of bubbles that `sides` chooses, or number of new bubbles

    /// Returns the number of bubbles that the event is to choose; 0 means all bubbles.
    std::size_t chosen_count() const;
};

/// The properties of a kind of event, and the shared keys that it accepts.
struct EventTraits {
    std::string_view name;         // the value of the key `kind`, such as "collapse"
    std::string_view meaning;      // what happens, in Markdown
    bool takes_bubbles = false;    // true if the kind accepts the keys `bubble` and `sides`
    bool takes_position = false;   // true if the kind accepts the key `at`
    bool takes_count = false;      // true if the kind accepts the key `count`
    bool creates_bubbles = false;  // true if the kind creates `count` bubbles
};

/// Returns the keys that determine when an event happens: `frame`, `frames` and `time`.
Keys<EventBase> time_keys();

/// Returns the keys that choose bubbles or a position: `bubble`, `at`, `sides` and `count`. `kinds`
/// lists all kinds of events. Each key is restricted to the kinds that accept it.
Keys<EventBase> choice_keys(const std::vector<EventTraits>& kinds);

}  // namespace foam::texgen
