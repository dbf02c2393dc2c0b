#include "texgen/maps/age.h"

#include "texgen/maps/cell_fill.h"

#include <algorithm>

namespace foam::texgen {

NumberPixels draw_age(FrameLayers& layers, const AgeOptions& options) {
    const Frame& frame = layers.frame();
    const FoamRecord& record = layers.record();
    const auto age_of = [&](BubbleIdentity bubble) {
        const double change = record.changes[bubble];
        const double birth = record.births[bubble];
        return frame.time - (options.since == AgeSince::Birth ? birth : std::max(birth, change));
    };
    const auto ages = per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return age_of(frame.bubbles[bubble].identity); },
        [&](const LoneBubble& bubble) { return age_of(bubble.identity); });
    return {fill_numbers(layers, ages), 0.0, options.full};
}

}  // namespace foam::texgen
