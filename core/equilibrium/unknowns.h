#pragma once

#include "core/equilibrium/ranks.h"
#include "core/foam/foam.h"

#include <span>
#include <vector>

namespace foam {

/// The unknowns that a solver works on, and the order in which it counts them: x and y of each free
/// junction, then the pressure of each free bubble, then the half angle of each free outer film,
/// all by increasing id. All others are held, and so is the ghost always.
struct Unknowns {
    std::vector<JunctionId> junctions;
    std::vector<BubbleId> bubbles;
    std::vector<FilmId> films;        // of the free junctions and bubbles, by increasing id
    std::vector<FilmId> outer_films;  // those of them whose half angle is free
    Ranks<JunctionId> junction_rank;  // place in `junctions`, negative for one that is held
    Ranks<BubbleId> bubble_rank;      // place in `bubbles`, likewise
    Ranks<FilmId> outer_rank;         // place in `outer_films`, likewise

    int size() const { return first_angle_row() + static_cast<int>(outer_films.size()); }
    int first_pressure_row() const { return static_cast<int>(2 * junctions.size()); }
    int first_angle_row() const { return first_pressure_row() + static_cast<int>(bubbles.size()); }
    /// Negative for a bubble that is held.
    int pressure_row(BubbleId bubble) const {
        const int rank = bubble_rank[bubble];
        return rank < 0 ? -1 : first_pressure_row() + rank;
    }
    /// Precondition: one of `outer_films`.
    int angle_row(FilmId film) const { return first_angle_row() + outer_rank[film]; }
    /// Row of the x coordinate; y follows it. Negative for a junction that is held.
    int position_row(JunctionId junction) const { return 2 * junction_rank[junction]; }
};

/// Everything in the foam that is alive.
Unknowns all_unknowns(const Network& network);

/// The given bubbles, the ghost not among them, in increasing order and each once, with all their
/// junctions.
Unknowns unknowns_around(const Network& network, std::span<const BubbleId> bubbles);

}  // namespace foam
