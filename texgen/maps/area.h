// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/map.h"
#include "texgen/maps/mean_bubble.h"

namespace foam::texgen {

inline constexpr MapTraits kAreaMap = {.name = "area",
                                       .meaning = "area of bubbles",
                                       .unit = "areas of the mean bubble; PNG: 0 to area.full",
                                       .channels = "Y",
                                       .png_bits = 16,
                                       .full_key = "area.full"};

struct AreaOptions {
    MeanBubble unit = MeanBubble::Seed;
    // The area that a PNG stores as its largest code (65535). Its unit is the area of the mean
    // bubble that `unit` selects.
    AutoReal full{4.0, true};
};

Keys<AreaOptions> area_keys();

/// Draws the area of every bubble (FrameBubble::area), divided by the area of the mean bubble that
/// options.unit selects. If a current moves the foam (loop.current), this is the area without the
/// current. A pixel that several bubbles share has the mean of their values, weighted by the part
/// of the pixel that each bubble covers. The image has one channel and is 0 around a patch.
NumberPixels draw_area(FrameLayers& layers, const AreaOptions& options);

}  // namespace foam::texgen
