// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/cycle_drive.h"

#include "core/foam/random.h"

#include <set>

namespace foam {

CycleDrive random_drive(const Foam& foam, const CycleOptions& options) {
    Random random(options.seed);
    CycleDrive drive;
    if (options.boiling > 0.0) {
        drive.boiling = choose_boiling_bubbles(
            foam, options.boiling, options.boiling_rise, options.steps, random);
    }
    std::set<BubbleIdentity> boiling;
    for (const BoilingBubble& bubble : drive.boiling) {
        boiling.insert(bubble.identity);
    }
    const auto add_oscillating = [&](BubbleIdentity identity, double area) {
        if (!boiling.contains(identity)) {
            drive.oscillating.push_back({identity, area, options.area_amplitude, random.uniform()});
        }
    };
    for (const BubbleId bubble : foam.network.bubbles()) {
        add_oscillating(foam.identities[bubble], foam.target_areas[bubble]);
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        add_oscillating(bubble.identity, bubble.target_area);
    }
    return drive;
}

}  // namespace foam
