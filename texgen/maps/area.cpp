// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/area.h"

#include "texgen/maps/cell_fill.h"

namespace foam::texgen {

Keys<AreaOptions> area_keys() {
    return {
        key("unit",
            kMeanBubbles,
            "unit of areas: mean area of the seeded foam (seed) or of the drawn frame (current)",
            &AreaOptions::unit),
        key("full",
            RealsOrAuto{1e-3, 1e6, AreaOptions().full},
            "area at the value 1 (white) of a PNG, in the unit area.unit; \"auto\" fits it to the "
            "largest area in the whole animation",
            &AreaOptions::full)
            .in("areas of the mean bubble, selected by area.unit")};
}

NumberPixels draw_area(FrameLayers& layers, const AreaOptions& options) {
    const Frame& frame = layers.frame();
    const double unit = area_of(options.unit, frame);
    const auto areas = per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].area / unit; },
        [&](const LoneBubble& bubble) { return bubble.target_area / unit; });
    return {fill_numbers(layers, areas), 0.0, options.full.value};
}

}  // namespace foam::texgen
