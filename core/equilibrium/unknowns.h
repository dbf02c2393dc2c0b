// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/rank_table.h"
#include "core/foam/foam.h"

#include <span>
#include <vector>

namespace foam {

/// The unknowns of a solver, in the order of their rows: x and y of each free junction, then the
/// pressure of each free bubble, then the half angle of each free outer film, all by increasing id.
/// Everything else is held fixed. The ghost is always held.
struct Unknowns {
    std::vector<JunctionId> junctions;
    std::vector<BubbleId> bubbles;
    std::vector<FilmId> films;            // films with a free end, by increasing id
    std::vector<FilmId> outer_films;      // the outer films among them
    RankTable<JunctionId> junction_rank;  // index in `junctions`, negative if held
    RankTable<BubbleId> bubble_rank;      // index in `bubbles`, negative if held
    RankTable<FilmId> outer_rank;         // index in `outer_films`, negative if held

    int size() const { return first_angle_row() + static_cast<int>(outer_films.size()); }
    int first_pressure_row() const { return static_cast<int>(2 * junctions.size()); }
    int first_angle_row() const { return first_pressure_row() + static_cast<int>(bubbles.size()); }
    /// Returns the row of the pressure; negative if the bubble is held.
    int pressure_row(BubbleId bubble) const {
        const int rank = bubble_rank[bubble];
        return rank < 0 ? -1 : first_pressure_row() + rank;
    }
    /// Returns the row of the half angle. Precondition: the film is one of `outer_films`.
    int angle_row(FilmId film) const { return first_angle_row() + outer_rank[film]; }
    /// Returns the row of the x coordinate, which is followed by the row of y; negative if the
    /// junction is held.
    int position_row(JunctionId junction) const { return 2 * junction_rank[junction]; }
};

/// Returns all unknowns of the foam.
Unknowns all_unknowns(const Network& network);

/// Returns the unknowns of some bubbles, of all their junctions, and of the outer films at these
/// junctions. Precondition: the bubbles are in increasing order, each once, without the ghost.
Unknowns unknowns_around(const Network& network, std::span<const BubbleId> bubbles);

}  // namespace foam
