// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kEventMap = {
    .name = "event",
    .meaning = "fading disks at recent T1 (red), T2 (green) and births (blue)",
    .unit = "0 to 1",
    .channels = "R G B",
    .png_filter = PngFilter::Up};

struct EventMapOptions {
    double radius = 1.0;  // radius of a disk, in diameters of a mean bubble of the seeded foam
    int fade = 8;         // number of frames that show a disk, at most kRecordedFrames
};

Keys<EventMapOptions> event_map_keys();

/// Draws disks where the topology of the foam has changed in recent frames: red for T1, green for
/// T2, blue for new bubbles. In a disk of radius R, the value at the distance r from the center is
/// (1 - r²/R²)² times a fade factor. Outside the disk, it is 0. The factor is 1 in the first frame
/// that shows the disk and falls linearly to 0 over options.fade frames. Where disks of one color
/// overlap, a pixel has their largest value. The image has three channels with values from 0 to 1.
NumberPixels draw_event(FrameLayers& layers, const EventMapOptions& options);

}  // namespace foam::texgen
