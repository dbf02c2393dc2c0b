// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <utility>
#include <vector>

namespace foam::texgen::test {

/// A run whose frames, from 1 on, have these times and numbers of bubbles on a torus of the first
/// one's number, and nothing else.
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
