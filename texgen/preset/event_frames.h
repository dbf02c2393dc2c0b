// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_base.h"
#include "texgen/preset/frames_options.h"

#include <optional>

namespace foam::texgen {

/// Returns the frames of an event. If the event has no time, the result is event.frames. If the
/// time is an interval, the result consists of the frames whose time step overlaps the interval.
/// The time step of a frame is the step from the preceding frame to this frame. If the time is an
/// instant, the result is the first frame that is not before the instant. Frames computed from a
/// time are never before frame 2. Returns nullopt if the time is after frame kLastEventFrame.
/// Precondition: the event has frames or a time.
std::optional<FrameSpan> frames_of(const EventBase& event, const FramesOptions& frames);

}  // namespace foam::texgen
