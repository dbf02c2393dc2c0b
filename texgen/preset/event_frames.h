#pragma once

#include "texgen/preset/event.h"
#include "texgen/preset/preset.h"

#include <optional>

namespace foam::texgen {

/// The last frame that an event may name.
inline constexpr int kLastEventFrame = 100'000;

/// The frames of an event: those that it names, or those whose ways from the frame before overlap
/// its time; for an instant, the first frame that is not before it. Never before frame 2. Nothing
/// where the time comes after frame kLastEventFrame. Precondition: it has frames or a time.
std::optional<FrameSpan> frames_of(const Event& event, const FramesOptions& frames);

}  // namespace foam::texgen
