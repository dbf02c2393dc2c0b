// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/rank_table.h"
#include "core/foam/foam.h"

#include <span>
#include <vector>

namespace foam {

/// The unknowns of a solver. In the solver's vectors and matrices, their rows are in this order:
/// - x and y of each free junction;
/// - the pressure of each free bubble;
/// - the half angle of each free outer film.
///
/// Each of the three kinds is ordered by increasing id. A free outer film is an outer film with a
/// free end. Everything that is not free is held, that is, not changed. The ghost is always held.
struct Unknowns {
    std::vector<JunctionId> junctions;
    std::vector<BubbleId> bubbles;
    std::vector<FilmId> films;            // films with a free end, by increasing id
    std::vector<FilmId> outer_films;      // the outer films in `films`
    RankTable<JunctionId> junction_rank;  // index in `junctions`, negative if held
    RankTable<BubbleId> bubble_rank;      // index in `bubbles`, negative if held
    RankTable<FilmId> outer_rank;  // index in `outer_films`, negative if held; empty on a torus

    int size() const { return first_angle_row() + static_cast<int>(outer_films.size()); }
    int first_pressure_row() const { return static_cast<int>(2 * junctions.size()); }
    int first_angle_row() const { return first_pressure_row() + static_cast<int>(bubbles.size()); }
    /// Returns the row of the pressure of the bubble; negative if the bubble is held.
    int pressure_row(BubbleId bubble) const {
        const int rank = bubble_rank[bubble];
        return rank < 0 ? -1 : first_pressure_row() + rank;
    }
    /// Returns the row of the half angle of the film. Precondition: the film is one of
    /// `outer_films`.
    int angle_row(FilmId film) const { return first_angle_row() + outer_rank[film]; }
    /// Returns the row of the x coordinate of the junction; negative if the junction is held. The y
    /// coordinate has the next row.
    int position_row(JunctionId junction) const { return 2 * junction_rank[junction]; }
};

/// Returns all unknowns of the foam.
Unknowns all_unknowns(const Network& network);

/// Returns the unknowns of a part of the foam, in which the given bubbles, all their junctions, and
/// the outer films at these junctions are free. Precondition: the bubbles are in increasing order
/// without duplicates, and the ghost is not one of them.
Unknowns unknowns_around(const Network& network, std::span<const BubbleId> bubbles);

}  // namespace foam
