// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/age.h"

#include "texgen/maps/cell_fill.h"

#include <algorithm>

namespace foam::texgen {

Keys<AgeOptions> age_keys() {
    constexpr Choices<AgeSince> kSince = {
        {{{"birth", AgeSince::Birth}, {"change", AgeSince::Change}}}};
    return {key("since",
                kSince,
                "moment from which the age counts: the birth of the bubble (time 0 for seeded "
                "bubbles), or the last time that it gained or lost a neighbor",
                &AgeOptions::since),
            key("full",
                RealsOrAuto{1e-6, 1e9, AgeOptions().full},
                "age at the value 1 (white) of a PNG, in foam time; \"auto\" fits it to the "
                "largest age in the whole animation",
                &AgeOptions::full)
                .in("foam time")};
}

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
    return {fill_numbers(layers, ages), 0.0, options.full.value};
}

}  // namespace foam::texgen
