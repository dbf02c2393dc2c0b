// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <map>
#include <vector>

namespace foam {

/// Finds the restless bubbles of a periodically driven foam: the bubbles whose neighbors keep
/// changing from cycle to cycle. They prevent the foam from returning to its first state.
class Unrest {
  public:
    /// Starts with a foam at the beginning of a cycle.
    explicit Unrest(const Foam& start);

    /// Compares the foam at the end of a cycle with the foam at the end of the cycle before.
    /// Returns the restless bubbles, by increasing identity: their neighbors changed in this cycle
    /// and also in earlier cycles. Changes in the first two cycles do not count, because every foam
    /// changes at first. Must be called once per cycle, since it stores the neighbors for the next
    /// call.
    std::vector<BubbleIdentity> restless_bubbles(const Foam& end);

  private:
    using Neighbors = std::map<BubbleIdentity, std::vector<BubbleIdentity>>;

    static Neighbors neighbors_of(const Foam& foam);

    Neighbors neighbors_;  // sorted neighbors of each bubble at the end of the last cycle
    // For each bubble, the sum of the weights of the cycles in which its neighbors changed. The
    // weight of the last cycle is 1; the weight of an older cycle decreases with its age.
    std::map<BubbleIdentity, double> unrest_;
    int cycles_ = 0;
};

}  // namespace foam
