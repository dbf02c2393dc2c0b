// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <utility>
#include <vector>

namespace foam::texgen::test {

/// Returns a run whose frames, numbered from 1, have these times and numbers of bubbles. The area
/// of the torus is the number of bubbles in the first frame. All other values are left at their
/// defaults.
inline RunRecord run_of(const std::vector<std::pair<double, int>>& frames) {
    RunRecord run{"made_up", 1.0, 0.01, {}};
    for (const auto& [time, bubbles] : frames) {
        FrameRecord record;
        record.frame = static_cast<int>(run.frames.size()) + 1;
        record.time = time;
        record.foam.bubbles = bubbles;
        record.foam.mean_area = static_cast<double>(frames.front().second) / bubbles;
        run.frames.push_back(record);
    }
    return run;
}

}  // namespace foam::texgen::test
