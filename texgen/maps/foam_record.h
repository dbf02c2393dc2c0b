#pragma once

#include "core/foam/topology_event.h"

#include <vector>

namespace foam::texgen {

/// A topology event on the way to a frame from the one before it.
struct RecordedEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    int frame = 0;
    Vec2 position{0.0, 0.0};  // in the plane; carried along if the foam has been sheared since

    friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// The number of frames that keep an event, including the first one that shows it.
inline constexpr int kRecordedFrames = 100;

/// The facts about earlier frames that the maps of a frame need. They do not depend on which of
/// these frames are drawn.
struct FoamRecord {
    /// The frame of the record, counted as in its events.
    int frame = 1;
    /// The pressures of all bubbles in the first equilibrium that a frame shows, over the film
    /// tension and times the root of the mean area, in increasing order. They scale the pressures
    /// of all frames, so that none flickers.
    std::vector<double> first_pressures{};
    /// By identity: when a bubble was born, and when its neighbours last changed; foam time. The
    /// seeded ones are of time 0.
    std::vector<double> births{};
    std::vector<double> changes{};
    /// In order. Events before frame 1 are kept only in a loop, where those of the cycle before
    /// have the frame numbers 1 and less.
    std::vector<RecordedEvent> events{};
};

}  // namespace foam::texgen
