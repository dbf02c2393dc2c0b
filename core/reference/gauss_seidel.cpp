// SPDX-License-Identifier: Apache-2.0

#include "core/reference/gauss_seidel.h"

#include "core/equilibrium/moves.h"
#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"
#include "core/parallel/parallel_for.h"
#include "core/reference/junction_coloring.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace foam {

// Blocked nonlinear Gauss-Seidel (E5; paper section 4.1). In sequential order, the blocks of all
// junctions are solved one after another, and each block starts from the state after the block
// before it. In colored order, junctions of one color share no bubble except the ghost. The blocks
// of one color are solved in parallel, and their changes are then applied in the order of the
// junctions. The paper mentions colored order as future work, with the colors red and black. The
// limit on the size of a step (largest_change) is not in the paper.

namespace {

constexpr std::size_t kBlocksPerChunk = 16;  // about 300 microseconds of work

// T1s of all short films are tried only every kSweepsBetweenT1 sweeps. In the first sweeps, while
// areas are far from their targets, a film that will be long in equilibrium may be short.
constexpr int kSweepsBetweenT1 = 30;

struct OuterChange {
    FilmId film;
    double half_angle;  // change of the half angle of the forward side, radians
};

// The changes of one block: positions and pressures in foam units, half angles in radians.
struct BlockChange {
    Vec2 move{0.0, 0.0};
    std::size_t bubble_count = 0;
    std::array<BubbleId, 3> bubbles{};
    std::array<double, 3> pressures{};
    std::vector<OuterChange> half_angles;
};

// Returns the Newton step of the block, scaled down if it exceeds the largest allowed change. If a
// film of the junction has length 0, returns a change of zero: the T1 rule handles such a film.
BlockChange change_of(const JunctionBlock& block, const GaussSeidelOptions& options) {
    BlockChange change;
    if (block.is_degenerate()) {
        return change;
    }
    BlockVector step = block_step(block, options.differences);
    const double size =
        std::max(step.head(step.size() - 2).cwiseAbs().maxCoeff(), step.tail<2>().norm());
    step *= std::min(1.0, options.largest_change / size);
    change.move = block.move(step);
    change.bubble_count = block.bubbles().size();
    for (std::size_t k = 0; k < change.bubble_count; ++k) {
        change.bubbles[k] = block.bubbles()[k];
        change.pressures[k] = block.pressure_change(step, k);
    }
    for (std::size_t k = 0; k < block.outer_films().size(); ++k) {
        change.half_angles.push_back({block.outer_films()[k], block.half_angle_change(step, k)});
    }
    return change;
}

// Adds the change of a block to the foam. Positions may leave the fundamental cell of the torus.
void apply(Foam& foam, JunctionId junction, const BlockChange& change) {
    foam.positions[junction] += change.move;
    for (std::size_t k = 0; k < change.bubble_count; ++k) {
        foam.pressures[change.bubbles[k]] += change.pressures[k];
    }
    for (const OuterChange& outer : change.half_angles) {
        const double angle = foam.half_angles[outer.film] + outer.half_angle;
        set_half_angle(foam, forward_side(outer.film), angle);
    }
}

class Sweeps {
  public:
    Sweeps(Foam& foam, const GaussSeidelOptions& options) : foam_(foam), options_(options) {}

    void sweep() {
        if (options_.order == SweepOrder::Sequential) {
            sweep_in_sequence();
        } else {
            sweep_by_color();
        }
    }

    // Applies the T1 rule after a sweep. `sweep` is the number of the sweep, counted from 1. If
    // this number is a multiple of kSweepsBetweenT1, the rule is applied to all films shorter than
    // the T1 distance of the thresholds, otherwise only to collapsed films (collapsed_length).
    // Returns the number of changes of the network.
    int flip_short_films(int sweep) {
        int flips = 0;
        for (const FilmId film : foam_.network.films()) {
            if (is_due(film, sweep % kSweepsBetweenT1 == 0)) {
                flips += apply_t1_rule(foam_, film, options_.thresholds) ? 1 : 0;
            }
        }
        if (flips > 0) {
            colors_.clear();
        }
        return flips;
    }

  private:
    bool is_due(FilmId film, bool all_short_films) const {
        const double length = chord(foam_, forward_side(film)).norm();
        return length < options_.thresholds.t1_distance &&
               (all_short_films || length < collapsed_length(foam_, film, options_.thresholds));
    }

    void sweep_in_sequence() {
        JunctionBlock block;
        for (const JunctionId junction : foam_.network.junctions()) {
            block.load(foam_, junction);
            apply(foam_, junction, change_of(block, options_));
        }
    }

    void sweep_by_color() {
        if (colors_.empty()) {
            colors_ = color_junctions(foam_.network);
        }
        for (const std::vector<JunctionId>& color : colors_) {
            sweep_color(color);
        }
    }

    // Solves all blocks of a color before any change is applied, because a block also reads the
    // pressures of the neighbors of its bubbles. Another block of the same color may change these
    // pressures.
    void sweep_color(const std::vector<JunctionId>& color) {
        changes_.resize(color.size());
        parallel_for(color.size(),
                     kBlocksPerChunk,
                     options_.threads,
                     [&](std::size_t first, std::size_t last) {
                         JunctionBlock block;
                         for (std::size_t k = first; k < last; ++k) {
                             block.load(foam_, color[k]);
                             changes_[k] = change_of(block, options_);
                         }
                     });
        for (std::size_t k = 0; k < color.size(); ++k) {
            apply(foam_, color[k], changes_[k]);
        }
    }

    Foam& foam_;
    const GaussSeidelOptions& options_;
    std::vector<std::vector<JunctionId>> colors_;  // empty until computed for the present network
    std::vector<BlockChange> changes_;
};

}  // namespace

GaussSeidelSummary gauss_seidel(Foam& foam, const GaussSeidelOptions& options) {
    GaussSeidelSummary summary;
    Sweeps sweeps(foam, options);
    bool converged = equilibrium_errors(foam).are_below(options.tolerance);
    while (!converged && summary.sweeps < options.max_sweeps) {
        sweeps.sweep();
        ++summary.sweeps;
        summary.t1 += sweeps.flip_short_films(summary.sweeps);
        converged = equilibrium_errors(foam).are_below(options.tolerance);
    }
    wrap(foam, all_unknowns(foam.network));
    summary.status = converged ? GaussSeidelStatus::Converged : GaussSeidelStatus::SweepLimit;
    return summary;
}

}  // namespace foam
