// SPDX-License-Identifier: Apache-2.0

#include "core/reference/junction_coloring.h"

#include <algorithm>
#include <array>

namespace foam {

// The blocks of junctions that share no bubble change different unknowns, so they can be solved in
// parallel. Sorting the blocks of a Gauss-Seidel method by colors is known as multicolor ordering
// (Saad, Iterative Methods for Sparse Linear Systems, 2003). The paper suggests red and black
// (section 6), but all junctions of a bubble need different colors. A block also reads the
// pressures of neighboring bubbles, which another block of its color may change. Therefore all
// blocks of a color are solved before any change is applied (sweep_color in gauss_seidel.cpp). The
// coloring is greedy: each junction gets the first color that is not yet used at any of its
// bubbles. Therefore only the used colors of each bubble are stored, and no graph of the conflicts
// between junctions.

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
