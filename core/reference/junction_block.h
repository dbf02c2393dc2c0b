// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam {

using BlockVector = Eigen::VectorXd;
using BlockMatrix = Eigen::MatrixXd;

/// One block of the paper's solver (eq. 11): a junction and the bubbles that meet there. All other
/// unknowns of the foam are fixed.
///
/// The unknowns are the changes of the pressures of the bubbles, followed by the changes of x and y
/// of the junction. The number of constraints is the same. The constraints are the areas of the
/// bubbles, followed by two angles between films of the junction. These are the angles on the left
/// of the first two half-edges of Network::leaving; the third angle follows from them (eq. 13). On
/// a torus, bubbles at the junction may be periodic copies of one bubble. This bubble counts once,
/// so that the block has fewer pressures and areas.
///
/// In a patch the ghost's pressure and area are left out of the block (paper eq. 15). Each outer
/// film of the block's bubbles adds one unknown and one constraint. The unknown is the change of
/// the film's half angle. The constraint is Laplace-Young's law (E1) at the film. In the order of
/// the unknowns, the half angles come after the pressures and before x and y. In the order of the
/// constraints, Laplace-Young's law comes after the areas and before the angles. Below 90 degrees,
/// the law determines the half angle. There, if the law holds before the Newton step, the step is
/// the same as without these unknowns and constraints. At 90 degrees, the half angle has no finite
/// derivative with respect to the pressures, but the step is still well defined.
///
/// All quantities are dimensionless and of order one for bubbles of any size. The unit of a
/// pressure is the film tension divided by the square root of the bubble's target area. The unit of
/// coordinates is the chord length of the junction's shortest film. The unit of an area is the
/// bubble's target area. Angles are in radians. The error of Laplace-Young's law is an error of the
/// sine of the half angle (bulge_energy.h).
class JunctionBlock {
  public:
    /// Reads the block of a junction from the foam and replaces the present block, whose memory is
    /// reused.
    void load(const Foam& foam, JunctionId junction);

    /// Returns the bubbles of the block, in the order of the unknowns. Each bubble occurs once; the
    /// ghost is left out.
    std::span<const BubbleId> bubbles() const { return {bubbles_.data(), bubble_count_}; }
    /// Returns the outer films of these bubbles, in the order of the unknowns.
    std::span<const FilmId> outer_films() const { return outer_films_; }

    /// Returns the number of unknowns, which is also the number of constraints.
    Eigen::Index size() const {
        return static_cast<Eigen::Index>(bubble_count_ + outer_films_.size()) + 2;
    }

    /// Returns true if a film of the junction has length 0. The angles between the films, and so
    /// the constraints, are then undefined.
    bool is_degenerate() const { return move_unit_ == 0.0; }

    /// Returns the errors of the constraints after a change of the unknowns (paper eq. 8 and 12).
    /// An error is the required value minus the actual value. The error of a bubble is its target
    /// area minus its area, divided by its target area. The error of an outer film is minus
    /// laplace_young_error (bulge_energy.h) along the film's forward side (HalfEdgeId). The error
    /// of an angle is 120 degrees minus the angle, in [-pi, pi] radians. The half angles of inner
    /// films follow from the pressures and are clamped to the limit of 80 degrees (film_energy.h).
    /// Precondition: the block is not degenerate.
    BlockVector constraint_errors(const BlockVector& change) const;

    /// Returns the change of a bubble's pressure, in foam units. `bubble` is an index in bubbles().
    double pressure_change(const BlockVector& change, std::size_t bubble) const;
    /// Returns the change of an outer film's half angle along its forward side, in radians.
    /// `outer_film` is an index in outer_films().
    double half_angle_change(const BlockVector& change, std::size_t outer_film) const {
        return change[static_cast<Eigen::Index>(bubble_count_ + outer_film)];
    }
    /// Returns the change of the junction's position, in foam units.
    Vec2 move(const BlockVector& change) const { return move_unit_ * change.tail<2>(); }

  private:
    // The data that the block stores for one half-edge. The half-edge has one of the block's
    // bubbles on its left, or its tail is the junction.
    struct Side {
        Vec2 start{0.0, 0.0};  // tail, relative to the start of the traversal of the bubble
        Vec2 chord{0.0, 0.0};
        double pressure = 0.0;      // left minus right, divided by the film tension
        double segment = 0.0;       // area between arc and chord, positive if it adds to the left
        double half_angle = 0.0;    // radians; only used for an outer film
        double start_weight = 0.0;  // 1 if the tail moves with the junction, else 0
        double chord_weight = 0.0;  // 1: only the head moves with the junction; -1: only the tail;
                                    // 0: neither of them, or both
        int left = kNoUnknown;      // index in bubbles_ of the bubble on the left, or kNoUnknown
        int right = kNoUnknown;     // index in bubbles_ of the bubble on the right, or kNoUnknown
        int outer = kNoUnknown;     // index in outer_films_, or kNoUnknown for an inner film
        double forward_sign = 1.0;  // 1 along the film's forward side, -1 against it
    };
    // Takes the place of an index: the bubble is not in the block, or the film is an inner film, so
    // that the block has no unknown for it.
    static constexpr int kNoUnknown = -1;

    void add_bubble(const Foam& foam, BubbleId bubble);
    void add_outer_films(const Network& network, BubbleId bubble);
    void add_sides(const Foam& foam, BubbleId bubble);
    Side side_of(const Foam& foam, HalfEdgeId h) const;
    int find(BubbleId bubble) const;
    int find(FilmId film) const;
    static FilmArc arc_of(const Side& side);
    static double direction_at_tail(const Side& side);
    static double segment_of(const Side& side);
    double pressure_change_at(const BlockVector& change, int index) const;
    Side changed(const Side& side, const BlockVector& change) const;

    JunctionId junction_ = kNone<JunctionId>;
    std::array<BubbleId, 3> bubbles_{};
    std::array<double, 3> targets_{};
    std::array<double, 3> pressure_units_{};  // units of the pressures, divided by film tension
    std::size_t bubble_count_ = 0;
    std::vector<FilmId> outer_films_;
    double tension_ = 1.0;
    double move_unit_ = 0.0;
    std::array<Side, 3> leaving_;  // sides whose tail is the junction
    std::vector<Side> sides_;      // sides of all bubbles of the block
};

}  // namespace foam
