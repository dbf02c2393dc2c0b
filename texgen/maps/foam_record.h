// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/topology_event.h"

#include <vector>

namespace foam::texgen {

/// A topology event between two consecutive frames.
struct RecordedEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    int frame = 0;            // first frame that shows the event, counted as FoamRecord describes
    Vec2 position{0.0, 0.0};  // foam units; moved along with the foam if it is sheared later

    friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// The values of a bubble by which maps choose its color or tone.
struct BubbleValues {
    double pressure = 0.0;  // pressure / film tension, in 1 / foam unit
    double area = 0.0;      // area within the arcs of the bubble, in square foam units
    double sides = 0.0;     // number of films around the bubble

    friend bool operator==(const BubbleValues&, const BubbleValues&) = default;
};

/// Averages over recent frames. In each frame, an average moves toward the present value by the
/// fraction 1 / (1 + FramesOptions::smoothing) of the difference. The first averages of a bubble
/// are its first values.
///
/// The pressure of a bubble that vanishes grows without limit. Therefore p / (1 + |p|) is averaged
/// instead of the pressure p. Here p is divided by the film tension and multiplied by the square
/// root of the mean area (PressureUnit::Current). The average changes by at most
/// 2 / (1 + smoothing) per frame.
struct RecentAverages {
    std::vector<BubbleValues> bubbles{};  // indexed by the bubble's identity;
                                          // BubbleValues::pressure is the average of p / (1 + |p|)
    double mean_area = 1.0;               // mean area of all bubbles, square foam units
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
    /// The pressures of all bubbles in the equilibrium at the end of the warm-up
    /// (FramesOptions::warm_up), in increasing order. They are in units of PressureUnit::Current:
    /// divided by the film tension and multiplied by the square root of the mean area. The map
    /// `pressure` takes percentiles and ranks from this list for all frames, which prevents
    /// flicker. If the map averages pressures over neighbors (if PressureOptions::smoothing or
    /// PressureOptions::flattening is above 0), it does not use the list. The list is empty before
    /// this equilibrium, for example in a frame 1 that shows the raw diagram (a seeded foam before
    /// its first equilibrium).
    std::vector<double> first_pressures{};
    /// The foam time of the last birth of each bubble, indexed by the bubble's identity. It is 0
    /// for a seeded bubble that has not been born again. For other bubbles, it is
    /// TopologyEvent::time, the start of the substep in which the bubble was last born. A boiling
    /// bubble is born again with its old identity. In the loops `breathe`, `shear` and `boil`, a
    /// birth more than one period before the frame counts as exactly one period before the frame.
    std::vector<double> births{};
    /// The foam time of the last change of each bubble's neighbors, indexed by the bubble's
    /// identity. If the neighbors have never changed, this is the time of the birth. In the loops
    /// `breathe`, `shear` and `boil`, these times are limited to one period in the same way as
    /// `births`.
    std::vector<double> changes{};
    /// The events of the last kRecordedFrames frames, in the order in which they happened. Events
    /// before frame 1 are kept only in the loops `breathe`, `shear` and `boil`, which repeat a
    /// cycle. Their frame numbers are at most 1: an event in the step to frame 1 has the number 1.
    std::vector<RecordedEvent> events{};
    /// Averages of values over recent frames; RecentAverages::bubbles is empty if nothing is
    /// averaged. In the loops `breathe`, `shear` and `boil` they are the averages after infinitely
    /// many cycles.
    RecentAverages averages{};
};

}  // namespace foam::texgen
