// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/unrest.h"

#include <algorithm>

// A T1 that is not undone by the end of its cycle is usually a single lasting change. In the
// following cycles, the neighbors are then the same at the end of each cycle. Where neighbors
// change again and again, the foam does not reach a periodic state, or its period is several
// cycles. The criterion is our own: changes are counted with exponentially decreasing weights, as
// in exponential smoothing, and compared with a threshold. With the constants below, a bubble is
// restless if its neighbors have changed twice, at most four cycles apart. If its neighbors change
// in every fifth cycle, it is restless from the third change on.

namespace foam {

namespace {

constexpr int kTransientCycles = 2;  // changes in these first cycles do not count
// In each cycle, the unrest of a bubble is multiplied by kMemory. Then 1 is added if the neighbors
// of the bubble have changed.
constexpr double kMemory = 0.8;
// A bubble whose neighbors have just changed is restless if its unrest is at least this number.
constexpr double kRestlessUnrest = 1.4;

}  // namespace

Unrest::Unrest(const Foam& start) : neighbors_(neighbors_of(start)) {}

std::vector<BubbleIdentity> Unrest::restless_bubbles(const Foam& end) {
    std::vector<BubbleIdentity> restless;
    Neighbors neighbors = neighbors_of(end);
    const bool counts = ++cycles_ > kTransientCycles;
    for (const auto& [bubble, around] : neighbors) {
        const auto before = neighbors_.find(bubble);
        const bool changed = before == neighbors_.end() || before->second != around;
        double& unrest = unrest_[bubble];
        unrest = kMemory * unrest + (counts && changed ? 1.0 : 0.0);
        if (changed && unrest >= kRestlessUnrest) {
            restless.push_back(bubble);
        }
    }
    neighbors_ = std::move(neighbors);
    return restless;
}

Unrest::Neighbors Unrest::neighbors_of(const Foam& foam) {
    Neighbors neighbors;
    for (const BubbleId bubble : foam.network.bubbles()) {
        std::vector<BubbleIdentity>& around = neighbors[foam.identities[bubble]];
        for (const HalfEdgeId h : foam.network.around(bubble)) {
            around.push_back(foam.identities[foam.network.right(h)]);
        }
        std::sort(around.begin(), around.end());
    }
    return neighbors;
}

}  // namespace foam
