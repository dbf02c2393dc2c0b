#pragma once

#include "core/foam/foam.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam {

/// At most three pressures and two coordinates, or three areas and two angles.
using BlockVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 5, 1>;
using BlockMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 5, 5>;

/// One block of the paper's solver (its eq. 11): a junction and the bubbles that meet there, all
/// else held.
///
/// Unknowns are changes of the pressures of the bubbles and then of x and y of the junction.
/// Constraints are as many: the areas of the bubbles, and then the angles between the junction's
/// films on the left of the first two of leaving(); the third angle follows (paper eq. 13). A
/// bubble that meets itself at the junction, around the torus, counts once: the block is smaller by
/// a pressure and an area.
///
/// Everything is without units, and of order one however small the bubbles are: a pressure is in
/// film tensions over the root of its bubble's target area, a coordinate in lengths of the
/// junction's shortest film, an area in target areas, an angle in radians.
class JunctionBlock {
  public:
    /// Takes what it needs from the foam; memory of an earlier junction is used again.
    void load(const Foam& foam, JunctionId junction);

    /// Each bubble once, in the order of the unknowns.
    std::span<const BubbleId> bubbles() const { return {bubbles_.data(), bubble_count_}; }

    /// Number of unknowns, and of constraints.
    Eigen::Index size() const { return static_cast<Eigen::Index>(bubble_count_) + 2; }

    /// Chords of the junction's films, away from it.
    std::array<Vec2, 3> chords() const;

    /// Whether a film of the junction has no length: there are then no angles and no constraints.
    bool is_degenerate() const { return move_unit_ == 0.0; }

    /// What the constraints lack after a change of the unknowns (paper eq. 8 and 12): target less
    /// area of each bubble, and 120 degrees less each angle, in [-pi, pi]. Half angles are held at
    /// the limit (film_energy.h). Precondition: not degenerate.
    BlockVector lacking(const BlockVector& change) const;

    /// A change of the unknowns in foam units.
    double pressure_change(const BlockVector& change, std::size_t bubble) const;
    Vec2 move(const BlockVector& change) const { return move_unit_ * change.tail<2>(); }

  private:
    // A film, with one of the bubbles on its left or with the junction at its tail.
    struct Side {
        Vec2 start{0.0, 0.0};  // relative to where the walk around the bubble began
        Vec2 chord{0.0, 0.0};
        double pressure = 0.0;     // left less right, in film tensions per length
        double segment = 0.0;      // area between arc and chord
        double start_share = 0.0;  // 1 where the start moves with the junction
        double chord_share = 0.0;  // 1 where the head does, less 1 where the start does
        int left = kHeld;          // the bubble's place in bubbles_
        int right = kHeld;
    };
    static constexpr int kHeld = -1;  // of a bubble outside the block

    void add_bubble(const Foam& foam, BubbleId bubble);
    void add_sides(const Foam& foam, BubbleId bubble);
    Side side_of(const Foam& foam, HalfEdgeId h) const;
    int place_of(BubbleId bubble) const;
    double pressure_change_at(const BlockVector& change, int place) const;
    Side changed(const Side& side, const BlockVector& change) const;

    JunctionId junction_ = kNone<JunctionId>;
    std::array<BubbleId, 3> bubbles_{};
    std::array<double, 3> targets_{};
    std::array<double, 3> pressure_units_{};  // in film tensions per length
    std::size_t bubble_count_ = 0;
    double tension_ = 1.0;
    double move_unit_ = 0.0;
    std::array<Side, 3> leaving_;
    std::vector<Side> sides_;  // of every bubble
};

}  // namespace foam
