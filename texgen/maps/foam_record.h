#pragma once

#include "core/foam/topology_event.h"

#include <vector>

namespace foam::texgen {

/// An event on the way to a frame from the one before it.
struct RecordedEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    int frame = 0;
    Vec2 place{0.0, 0.0};  // in the plane; carried along where the foam has been sheared since

    friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// For so many frames an event is kept, the one that shows it first among them.
inline constexpr int kRecordedFrames = 100;

/// What the maps of a frame need to know of the frames before it; the same whichever of them are
/// drawn.
struct FoamRecord {
    /// The frame that it belongs to, in the numbers that events have.
    int frame = 1;
    /// The pressures of all bubbles in the first equilibrium that a frame shows, over the film
    /// tension and times the root of the mean area, in increasing order. They scale the pressures
    /// of all frames, so that none flickers.
    std::vector<double> first_pressures{};
    /// By identity: when a bubble was born, and when its neighbours last changed; foam time. The
    /// seeded ones are of time 0.
    std::vector<double> births{};
    std::vector<double> changes{};
    /// In their order. None of those before frame 1, but in a loop, where those of the cycle before
    /// have the numbers 1 and less.
    std::vector<RecordedEvent> events{};
};

}  // namespace foam::texgen
