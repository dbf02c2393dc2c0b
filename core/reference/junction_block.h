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

/// One block of the paper's solver (eq. 11): a junction and the bubbles that meet there, with
/// everything else held.
///
/// The unknowns are the changes of the pressures of the bubbles, followed by the changes of x and y
/// of the junction. There are as many constraints: the areas of the bubbles, followed by two angles
/// between films of the junction. These are the angles on the left of the first two half-edges of
/// Network::leaving; the third angle follows from them (paper eq. 13). A bubble that meets itself
/// at the junction, around the torus, counts once: the block then has one pressure and one area
/// less.
///
/// In a patch the ghost's pressure and area are left out of the block (paper eq. 15). Each outer
/// film of the block's bubbles has its half angle as an unknown, after the pressures, and
/// Laplace-Young's law as a constraint, after the areas. Where this law determines the half angle,
/// the Newton step is the same as for a block without these unknowns and constraints. At 90 degrees
/// the law does not determine the half angle, but the step is still well defined.
///
/// All quantities are dimensionless, and of order one for bubbles of any size. Pressures are in
/// film tensions over the square root of the bubble's target area, coordinates in lengths of the
/// junction's shortest film, areas in target areas, angles in radians, and the error of
/// Laplace-Young's law in film tensions.
class JunctionBlock {
  public:
    /// Reads the block of a junction from the foam. Memory of an earlier block is reused.
    void load(const Foam& foam, JunctionId junction);

    /// Return the bubbles, each once, and the outer films, both in the order of the unknowns.
    std::span<const BubbleId> bubbles() const { return {bubbles_.data(), bubble_count_}; }
    std::span<const FilmId> outer_films() const { return outer_films_; }

    /// Returns the number of unknowns, which is also the number of constraints.
    Eigen::Index size() const {
        return static_cast<Eigen::Index>(bubble_count_ + outer_films_.size()) + 2;
    }

    /// Returns the chords of the junction's films, pointing away from it.
    std::array<Vec2, 3> chords() const;

    /// Returns true if a film of the junction has no length. The angles, and so the constraints,
    /// are then undefined.
    bool is_degenerate() const { return move_unit_ == 0.0; }

    /// Returns the errors of the constraints after a change of the unknowns (paper eq. 8 and 12).
    /// An error is the required value minus the actual value. For a bubble it is the target area
    /// minus the area, divided by the target area. For an outer film it is minus
    /// laplace_young_error (bulge_energy.h) along the forward side. For an angle it is 120 degrees
    /// minus the angle, in [-pi, pi] radians. Half angles of other films are clamped to the limit
    /// (film_energy.h). Precondition: the block is not degenerate.
    BlockVector constraint_errors(const BlockVector& change) const;

    /// Returns the change of a bubble's pressure, in foam units. `bubble` is an index in bubbles().
    double pressure_change(const BlockVector& change, std::size_t bubble) const;
    /// Returns the change of an outer film's half angle along its forward side, in radians.
    /// `outer_film` is an index in outer_films().
    double half_angle_change(const BlockVector& change, std::size_t outer_film) const {
        return change[static_cast<Eigen::Index>(bubble_count_ + outer_film)];
    }
    /// Returns the motion of the junction, in foam units.
    Vec2 move(const BlockVector& change) const { return move_unit_ * change.tail<2>(); }

  private:
    // A side of a film: either a side of one of the bubbles, which is on its left, or a side whose
    // tail is the junction.
    struct Side {
        Vec2 start{0.0, 0.0};  // tail, relative to the start of the traversal of the bubble
        Vec2 chord{0.0, 0.0};
        double pressure = 0.0;      // left minus right, in film tensions per length
        double segment = 0.0;       // area between arc and chord, counted for the left side
        double half_angle = 0.0;    // only used for an outer film
        double start_weight = 0.0;  // 1 if the tail moves with the junction, else 0
        double chord_weight = 0.0;  // 1 if only the head moves with it, -1 if only the tail does
        int left = kHeld;           // index in bubbles_ of the bubble on the left
        int right = kHeld;
        int outer = kHeld;          // index in outer_films_
        double forward_sign = 1.0;  // 1 along the film's forward side, -1 against it
    };
    static constexpr int kHeld = -1;  // index of a bubble outside of the block or of an inner film

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
    std::array<double, 3> pressure_units_{};  // in film tensions per length
    std::size_t bubble_count_ = 0;
    std::vector<FilmId> outer_films_;
    double tension_ = 1.0;
    double move_unit_ = 0.0;
    std::array<Side, 3> leaving_;
    std::vector<Side> sides_;  // sides of all bubbles
};

}  // namespace foam
