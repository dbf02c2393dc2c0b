#include "core/equilibrium/spots.h"

#include <algorithm>
#include <cmath>

namespace foam {

namespace {

using Marks = Indexed<BubbleId, std::uint8_t>;

class BubbleSet {
  public:
    explicit BubbleSet(const Network& network)
        : marks_(network.bubble_slots(), 0), ghost_(network.ghost()) {}

    // The ghost is never in a set.
    void add(BubbleId bubble) {
        if (marks_[bubble] == 0 && bubble != ghost_) {
            marks_[bubble] = 1;
            bubbles_.push_back(bubble);
        }
    }

    void add_ring(const Network& network) {
        const std::size_t count = bubbles_.size();
        for (std::size_t k = first_of_last_ring_; k < count; ++k) {
            for (const HalfEdgeId h : network.around(bubbles_[k])) {
                add(network.right(h));
            }
        }
        first_of_last_ring_ = count;
    }

    std::size_t size() const { return bubbles_.size(); }

    // The set in connected parts, each in increasing order; leaves the set empty.
    std::vector<Spot> take_parts(const Network& network) {
        std::sort(bubbles_.begin(), bubbles_.end());
        std::vector<Spot> parts;
        for (const BubbleId bubble : bubbles_) {
            if (marks_[bubble] != 0) {
                parts.push_back(take_part(network, bubble));
            }
        }
        bubbles_.clear();
        return parts;
    }

  private:
    Spot take_part(const Network& network, BubbleId start) {
        Spot part{start};
        marks_[start] = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            for (const HalfEdgeId h : network.around(part[k])) {
                const BubbleId neighbour = network.right(h);
                if (marks_[neighbour] != 0) {
                    marks_[neighbour] = 0;
                    part.push_back(neighbour);
                }
            }
        }
        std::sort(part.begin(), part.end());
        return part;
    }

    Marks marks_;
    BubbleId ghost_;
    std::vector<BubbleId> bubbles_;
    std::size_t first_of_last_ring_ = 0;
};

void add_bad_bubbles(const Foam& foam,
                     const Unknowns& unknowns,
                     const Eigen::VectorXd& residual,
                     const SpotOptions& options,
                     BubbleSet& bad) {
    for (const BubbleId bubble : unknowns.bubbles) {
        const double error = residual[unknowns.pressure_row(bubble)] / foam.target_areas[bubble];
        if (!(std::abs(error) < options.area)) {
            bad.add(bubble);
        }
    }
    for (const JunctionId junction : unknowns.junctions) {
        const Vec2 force = residual.segment<2>(unknowns.position_row(junction));
        if (!(force.norm() < options.force * foam.film_tension)) {
            for (const HalfEdgeId h : foam.network.leaving(junction)) {
                bad.add(foam.network.left(h));
            }
        }
    }
}

}  // namespace

std::vector<Spot> find_spots(const Foam& foam,
                             const Unknowns& unknowns,
                             const Eigen::VectorXd& residual,
                             const SpotOptions& options) {
    BubbleSet set(foam.network);
    add_bad_bubbles(foam, unknowns, residual, options, set);
    const double most = options.largest_share * static_cast<double>(unknowns.bubbles.size());
    for (int ring = 0; ring < options.rings; ++ring) {
        set.add_ring(foam.network);
    }
    return static_cast<double>(set.size()) > most ? std::vector<Spot>{}
                                                  : set.take_parts(foam.network);
}

}  // namespace foam
