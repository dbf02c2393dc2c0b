// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_base.h"
#include "texgen/preset/frames_options.h"

#include <optional>

namespace foam::texgen {

/// Returns the frames of an event. If the event names frames, these are returned. If it has a span
/// of time, the result is the frames whose interval since the preceding frame overlaps the span;
/// for an instant, the first frame that is not before it. Frames computed from a time are never
/// before frame 2. Returns nullopt if the time is after frame kLastEventFrame. Precondition: the
/// event has frames or a time.
std::optional<FrameSpan> frames_of(const EventBase& event, const FramesOptions& frames);

}  // namespace foam::texgen
