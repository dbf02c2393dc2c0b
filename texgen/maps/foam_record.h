// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_event.h"

#include <vector>

namespace foam::texgen {

/// A topology event between two consecutive frames.
struct RecordedEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    int frame = 0;            // the first frame that shows the event
    Vec2 position{0.0, 0.0};  // moved along with the foam if the foam is sheared later

    friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// The number of frames for which a record keeps an event, including the first frame that shows it.
inline constexpr int kRecordedFrames = 100;

/// The facts about earlier frames that the maps of a frame need. They do not depend on which of the
/// earlier frames are drawn.
struct FoamRecord {
    /// The number of the frame that the record belongs to, counted like RecordedEvent::frame.
    int frame = 1;
    /// The pressures of all bubbles in the first equilibrium that a frame shows, in increasing
    /// order and in units of PressureUnit::Current: divided by the film tension and multiplied by
    /// the square root of the mean area. They define the scale of pressures for all frames, which
    /// prevents flicker.
    std::vector<double> first_pressures{};
    /// The foam times at which each bubble was born and at which its neighbors last changed,
    /// indexed by the bubble's identity. Both start at 0 for seeded bubbles.
    std::vector<double> births{};
    std::vector<double> changes{};
    /// The events in the order in which they happened. Events before frame 1 are kept only in a
    /// loop: events of the preceding cycle have frame numbers of 1 and less.
    std::vector<RecordedEvent> events{};
};

}  // namespace foam::texgen
