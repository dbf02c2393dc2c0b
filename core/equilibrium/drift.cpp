// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/drift.h"

#include <algorithm>
#include <vector>

namespace foam {

namespace {

// Returns the median; for an even number of values, the upper of the two in the middle. Changes the
// order of the values. Precondition: `values` is not empty.
double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

void undo_drift(Foam& foam, const Positions& earlier) {
    std::vector<double> along_x;
    std::vector<double> along_y;
    for (const JunctionId junction : foam.network.junctions()) {
        const Vec2 motion = foam.domain.nearest_copy(foam.positions[junction] - earlier[junction]);
        along_x.push_back(motion.x());
        along_y.push_back(motion.y());
    }
    if (along_x.empty()) {
        return;
    }
    const Vec2 drift(median(along_x), median(along_y));
    if (drift != Vec2::Zero()) {
        translate(foam, -drift);
    }
}

}  // namespace foam
