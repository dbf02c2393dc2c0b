#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kEventMap = {
    .name = "event",
    .meaning = "spots where T1 (red), T2 (green) and births (blue) just happened, fading",
    .unit = "0 to 1",
    .channels = "R G B",
    .png_filter = PngFilter::Up};

struct EventMapOptions {
    double radius = 1.0;  // of a spot, in diameters of a mean bubble of the seeded foam
    int fade = 8;         // frames until a spot is gone, up to kRecordedFrames
};

Keys<EventMapOptions> event_map_keys();

/// Draws spots where the topology of the foam has just changed: red for T1, green for T2, blue for
/// new bubbles. A spot has the profile (1 - r²/R²)², times 1 in the first frame that shows it and
/// falling evenly to 0 over the next frames. Where spots overlap, the highest counts. Three
/// channels, 0 to 1.
NumberPixels draw_event(FrameLayers& layers, const EventMapOptions& options);

}  // namespace foam::texgen
