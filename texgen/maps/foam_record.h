// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_event.h"

#include <vector>

namespace foam::texgen {

/// A topology event between two consecutive frames.
struct RecordedEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    int frame = 0;            // first frame that shows the event, counted as FoamRecord describes
    Vec2 position{0.0, 0.0};  // moved along with the foam if the foam is sheared later

    friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// The number of frames for which a record keeps an event, including the first frame that shows it.
inline constexpr int kRecordedFrames = 100;

/// The facts about earlier frames that the maps of a frame need. The facts do not depend on which
/// of the earlier frames are drawn. In a record, frames are counted like the states of the
/// simulation (animation/README.md). In the loops `flow` and `pingpong`, the frames of the
/// animation have other numbers.
struct FoamRecord {
    /// The number of the frame to which the record belongs; the first frame is 1.
    int frame = 1;
    /// The pressures of all bubbles in the equilibrium at the end of the warm-up, in increasing
    /// order and in units of PressureUnit::Current: divided by the film tension and multiplied by
    /// the square root of the mean area. The map `pressure` takes percentiles and ranks from this
    /// list for all frames, which prevents flicker. The list is empty before this equilibrium, for
    /// example in a frame 1 that shows the raw diagram.
    std::vector<double> first_pressures{};
    /// The foam time of the birth of each bubble, indexed by the bubble's identity. A bubble born
    /// between two frames has the time of the earlier frame. Seeded bubbles, and bubbles born
    /// during the warm-up, have 0. In the loops `breathe` and `shear`, a time that is more than one
    /// period before the frame is replaced by the time one period before the frame.
    std::vector<double> births{};
    /// The foam time of the last change of each bubble's neighbors, indexed by the bubble's
    /// identity. If the neighbors have never changed, this is the time of the birth. Limited to one
    /// period like `births`.
    std::vector<double> changes{};
    /// The events of the last kRecordedFrames frames, in the order in which they happened. Events
    /// before frame 1 are kept only in the loops `breathe` and `shear`, which repeat a cycle:
    /// events of the cycles before frame 1 have frame numbers of at most 1.
    std::vector<RecordedEvent> events{};
};

}  // namespace foam::texgen
