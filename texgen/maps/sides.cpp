// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/sides.h"

#include "texgen/maps/cell_fill.h"

namespace foam::texgen {

IdPixels draw_sides(FrameLayers& layers) {
    const Frame& frame = layers.frame();
    const auto sides = per_bubble<std::uint32_t>(
        frame,
        [&](BubbleId bubble) { return static_cast<std::uint32_t>(frame.network.sides(bubble)); },
        [](const LoneBubble&) { return std::uint32_t{0}; });
    return paint_ids(layers, sides);
}

}  // namespace foam::texgen
