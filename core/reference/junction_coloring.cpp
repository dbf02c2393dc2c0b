// SPDX-License-Identifier: Apache-2.0

#include "core/reference/junction_coloring.h"

#include <algorithm>
#include <array>

namespace foam {

namespace {

class Coloring {
  public:
    explicit Coloring(const Network& network)
        : network_(network), used_colors_(network.bubble_slots()) {}

    // Returns the first color that is not yet used at any bubble of the junction, and marks the
    // color as used at these bubbles. The ghost does not count as a bubble.
    std::size_t take(JunctionId junction) {
        const std::array<HalfEdgeId, 3> leaving = network_.leaving(junction);
        std::size_t color = 0;
        while (std::any_of(leaving.begin(), leaving.end(), [&](HalfEdgeId h) {
            const std::vector<bool>& used_colors = used_colors_[network_.left(h)];
            return color < used_colors.size() && used_colors[color];
        })) {
            ++color;
        }
        for (const HalfEdgeId h : leaving) {
            if (network_.left(h) != network_.ghost()) {
                mark_used(network_.left(h), color);
            }
        }
        return color;
    }

  private:
    void mark_used(BubbleId bubble, std::size_t color) {
        std::vector<bool>& used_colors = used_colors_[bubble];
        used_colors.resize(std::max(used_colors.size(), color + 1));
        used_colors[color] = true;
    }

    const Network& network_;
    Indexed<BubbleId, std::vector<bool>> used_colors_;  // by bubble and color: true if used
};

}  // namespace

std::vector<std::vector<JunctionId>> color_junctions(const Network& network) {
    std::vector<std::vector<JunctionId>> colors;
    Coloring coloring(network);
    for (const JunctionId junction : network.junctions()) {
        const std::size_t color = coloring.take(junction);
        colors.resize(std::max(colors.size(), color + 1));
        colors[color].push_back(junction);
    }
    return colors;
}

}  // namespace foam
