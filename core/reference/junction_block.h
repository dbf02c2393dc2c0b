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

/// One block of the paper's solver (its eq. 11): a junction and the bubbles that meet there, with
/// everything else held.
///
/// Unknowns are changes of the pressures of the bubbles and then of x and y of the junction.
/// Constraints are as many: the areas of the bubbles, and then the angles between the junction's
/// films on the left of the first two of leaving(); the third angle follows (paper eq. 13). A
/// bubble that meets itself at the junction, around the torus, counts once: the block is smaller by
/// a pressure and an area.
///
/// In a patch the ghost's pressure and area leave the block (paper eq. 15). Each outer film of the
/// block's bubbles has its half angle as an unknown, after the pressures, and Laplace-Young's law
/// as a constraint, after the areas. Where this law alone tells the half angle, Newton's step is
/// that of the block without both; and it is as good at 90 degrees, where the law does not.
///
/// Everything is without units, and of order one however small the bubbles are: a pressure is in
/// film tensions over the root of its bubble's target area, a coordinate in lengths of the
/// junction's shortest film, an area in target areas, an angle in radians, the error of
/// Laplace-Young's law in film tensions.
class JunctionBlock {
  public:
    /// Reads the block of a junction from the foam; memory of an earlier block is reused.
    void load(const Foam& foam, JunctionId junction);

    /// The bubbles, each once, and the outer films, in the order of the unknowns.
    std::span<const BubbleId> bubbles() const { return {bubbles_.data(), bubble_count_}; }
    std::span<const FilmId> outer_films() const { return outer_films_; }

    /// Number of unknowns, and of constraints.
    Eigen::Index size() const {
        return static_cast<Eigen::Index>(bubble_count_ + outer_films_.size()) + 2;
    }

    /// Returns the chords of the junction's films, away from it.
    std::array<Vec2, 3> chords() const;

    /// Returns true if a film of the junction has no length: then there are no angles, and no
    /// constraints.
    bool is_degenerate() const { return move_unit_ == 0.0; }

    /// Returns the errors of the constraints after a change of the unknowns (paper eq. 8 and 12):
    /// target minus area of each bubble, the error of Laplace-Young's law (bulge_energy.h) at each
    /// outer film, along its forward side, and 120 degrees minus each angle, in [-pi, pi]. Half
    /// angles of other films are clamped to the limit (film_energy.h). Precondition: not
    /// degenerate.
    BlockVector constraint_errors(const BlockVector& change) const;

    /// Return the parts of a change of the unknowns in foam units.
    double pressure_change(const BlockVector& change, std::size_t bubble) const;
    /// The change along the outer film's forward side.
    double half_angle_change(const BlockVector& change, std::size_t outer_film) const {
        return change[static_cast<Eigen::Index>(bubble_count_ + outer_film)];
    }
    Vec2 move(const BlockVector& change) const { return move_unit_ * change.tail<2>(); }

  private:
    // A film, with one of the bubbles on its left or with the junction at its tail.
    struct Side {
        Vec2 start{0.0, 0.0};  // relative to the start of the traversal of the bubble
        Vec2 chord{0.0, 0.0};
        double pressure = 0.0;     // left less right, in film tensions per length
        double segment = 0.0;      // area between arc and chord
        double half_angle = 0.0;   // only of an outer film
        double start_share = 0.0;  // 1 if the start moves with the junction
        double chord_share = 0.0;  // 1 if the head does, minus 1 if the start does
        int left = kHeld;          // index of the bubble in bubbles_
        int right = kHeld;
        int outer = kHeld;           // index of the film in outer_films_
        double forward_share = 1.0;  // 1 along the film's forward side, -1 against it
    };
    static constexpr int kHeld = -1;  // index of a bubble outside, or of an inner film

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
    std::vector<Side> sides_;  // of all bubbles
};

}  // namespace foam
