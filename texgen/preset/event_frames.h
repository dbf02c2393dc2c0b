#pragma once

#include "texgen/events/event_base.h"
#include "texgen/preset/frames_options.h"

#include <optional>

namespace foam::texgen {

/// Returns the frames of an event: those that it names, or those whose ways from the frame before
/// overlap its time; for an instant, the first frame that is not before it. They never begin before
/// frame 2. Returns nothing if the time comes after frame kLastEventFrame. Precondition: the event
/// has frames or a time.
std::optional<FrameSpan> frames_of(const EventBase& event, const FramesOptions& frames);

}  // namespace foam::texgen
