// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <map>
#include <vector>

namespace foam {

/// Finds the bubbles that prevent a periodically driven foam from returning to its first state:
/// those whose neighbors keep changing from cycle to cycle.
class Unrest {
  public:
    /// Starts with a foam at the beginning of a cycle.
    explicit Unrest(const Foam& start);

    /// Takes the foam at the end of the next cycle. Returns the bubbles that have other neighbors
    /// than at its beginning, and had other neighbors in earlier cycles as well. Returns nothing
    /// after the first cycles, in which the foam changes in any case.
    std::vector<BubbleIdentity> restless_bubbles(const Foam& end);

  private:
    using Neighbors = std::map<BubbleIdentity, std::vector<BubbleIdentity>>;

    static Neighbors neighbors_of(const Foam& foam);

    Neighbors neighbors_;  // sorted; at the end of the last cycle
    // For each bubble: 1 for each cycle in which its neighbors changed, less the older the cycle.
    std::map<BubbleIdentity, double> unrest_;
    int cycles_ = 0;
};

}  // namespace foam
