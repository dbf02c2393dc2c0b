// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/defect_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace foam {

// The residual shows which bubbles are at defects. The set of these bubbles is grown by rings of
// neighbors, and a breadth-first search divides the set into connected regions.

namespace {

// A set of bubbles that grows by rings of neighbors. The ghost is never in it.
class BubbleSet {
  public:
    explicit BubbleSet(const Network& network)
        : network_(network), marks_(network.bubble_slots(), 0) {}

    void add(BubbleId bubble) {
        if (marks_[bubble] == 0 && bubble != network_.ghost()) {
            marks_[bubble] = 1;
            bubbles_.push_back(bubble);
        }
    }

    void add_ring() {
        const std::size_t count = bubbles_.size();
        for (std::size_t k = first_of_last_ring_; k < count; ++k) {
            for (const HalfEdgeId h : network_.around(bubbles_[k])) {
                add(network_.right(h));
            }
        }
        first_of_last_ring_ = count;
    }

    std::size_t size() const { return bubbles_.size(); }

    // Returns the connected parts of the set, each sorted by id, and empties the set.
    std::vector<DefectRegion> take_parts() {
        std::sort(bubbles_.begin(), bubbles_.end());
        std::vector<DefectRegion> parts;
        for (const BubbleId bubble : bubbles_) {
            if (marks_[bubble] != 0) {
                parts.push_back(take_part(bubble));
            }
        }
        bubbles_.clear();
        return parts;
    }

  private:
    // Finds the connected part of the set that contains `start` by breadth-first search, removes
    // the marks of its bubbles, and returns it.
    DefectRegion take_part(BubbleId start) {
        DefectRegion part{start};
        marks_[start] = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            for (const HalfEdgeId h : network_.around(part[k])) {
                const BubbleId neighbor = network_.right(h);
                if (marks_[neighbor] != 0) {
                    marks_[neighbor] = 0;
                    part.push_back(neighbor);
                }
            }
        }
        std::sort(part.begin(), part.end());
        return part;
    }

    const Network& network_;
    Indexed<BubbleId, std::uint8_t> marks_;
    std::vector<BubbleId> bubbles_;
    std::size_t first_of_last_ring_ = 0;
};

// Adds the bubbles with a large area error and the three bubbles at each junction with a large
// force. A NaN counts as a defect, which is why the comparisons are negated.
void add_defects(const Foam& foam,
                 const Unknowns& unknowns,
                 const Eigen::VectorXd& residual,
                 const DefectOptions& options,
                 BubbleSet& set) {
    for (const BubbleId bubble : unknowns.bubbles) {
        const double error = residual[unknowns.pressure_row(bubble)] / foam.target_areas[bubble];
        if (!(std::abs(error) < options.area)) {
            set.add(bubble);
        }
    }
    for (const JunctionId junction : unknowns.junctions) {
        const Vec2 force = residual.segment<2>(unknowns.position_row(junction));
        if (!(force.norm() < options.force * foam.film_tension)) {
            for (const HalfEdgeId h : foam.network.leaving(junction)) {
                set.add(foam.network.left(h));
            }
        }
    }
}

}  // namespace

std::vector<DefectRegion> find_defect_regions(const Foam& foam,
                                              const Unknowns& unknowns,
                                              const Eigen::VectorXd& residual,
                                              const DefectOptions& options) {
    BubbleSet set(foam.network);
    add_defects(foam, unknowns, residual, options, set);
    for (int ring = 0; ring < options.rings; ++ring) {
        set.add_ring();
    }
    const double limit = options.largest_fraction * static_cast<double>(unknowns.bubbles.size());
    return static_cast<double>(set.size()) > limit ? std::vector<DefectRegion>{} : set.take_parts();
}

}  // namespace foam
