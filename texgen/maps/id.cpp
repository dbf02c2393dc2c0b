// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/id.h"

#include "texgen/maps/cell_fill.h"

namespace foam::texgen {

IdPixels draw_id(FrameLayers& layers) {
    const Frame& frame = layers.frame();
    const auto ids = per_bubble<std::uint32_t>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].identity + 1; },
        [](const LoneBubble& bubble) { return bubble.identity + 1; });
    return paint_ids(layers, ids);
}

}  // namespace foam::texgen
