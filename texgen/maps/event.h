#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

struct EventMapOptions {
    double radius = 1.0;  // of a spot, in diameters of a mean bubble of the seeded foam
    int fade = 8;         // frames until a spot is gone, up to kRecordedFrames
};

/// Spots where the foam's neighbourhoods have just changed: red for T1, green for T2, blue for new
/// bubbles. A spot is (1 - r²/R²)² high, times 1 in the first frame that shows it and falling
/// evenly to 0 over the frames after; where spots overlap, the highest counts. Three channels, 0 to
/// 1.
NumberPixels draw_event(FrameLayers& layers, const EventMapOptions& options);

}  // namespace foam::texgen
