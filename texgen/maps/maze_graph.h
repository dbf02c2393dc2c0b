// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace foam::texgen {

/// The parameters with which a maze is built from a foam. The bubbles are the rooms of the maze and
/// the films its walls; some films are opened, which makes passages between bubbles (find_maze).
struct MazeRule {
    // The weight of chance in the choice of the films to open. The weight of the difference of the
    // pressures on both sides of a film is 1 - chance.
    double chance = 0.4;
    std::int64_t seed = 1;  // seed of the random numbers
    // After the spanning tree has been built, this fraction (0 to 1) of the remaining walls between
    // bubbles is opened to make loops.
    double loops = 0.0;
    // A length in foam units. A film is narrow if it is shorter than this length, or if a bubble
    // beside it has a smaller area than a circle with this diameter. Narrow films are opened only
    // after all other films.
    double narrow_length = 0.0;

    friend bool operator<(const MazeRule& a, const MazeRule& b) {
        return std::tie(a.chance, a.seed, a.loops, a.narrow_length) <
               std::tie(b.chance, b.seed, b.loops, b.narrow_length);
    }
};

/// A maze whose rooms are the bubbles of a foam and whose walls are its films, some of which are
/// open. `solution` is the path through the fewest bubbles between two ends (find_maze).
struct Maze {
    Indexed<FilmId, std::uint8_t> is_open;  // 1 for open films, 0 for walls
    /// The films that the solution passes, in order. The solution leaves the bubble on the left of
    /// each half-edge and enters the bubble on its right. On a patch the first half-edge has the
    /// ghost on its left and the last one has the ghost on its right. Empty if there is no
    /// solution.
    std::vector<HalfEdgeId> solution;
};

/// Builds a maze. The open films between bubbles form a minimum spanning tree (J. B. Kruskal, "On
/// the shortest spanning subtree of a graph and the traveling salesman problem", 1956). Exactly one
/// path therefore connects any two bubbles of a torus, or of a raft of a patch. The weight of a
/// film is a mix of two numbers. One is the difference of the pressures on its sides, which makes
/// passages follow bubbles of similar pressure. The other is a random number that depends on the
/// seed and on the identities of both bubbles. If rule.loops is above 0, further films are opened,
/// and several paths may connect two bubbles.
///
/// The ends of the solution are two bubbles that are as far apart in the tree as possible. On a
/// torus, any bubble can be an end. On a patch, the ends are at the rim or beside a hole. The
/// longest outer film of each end is open; these films are the entrance and the exit. Bubbles whose
/// longest outer film has at least the length rule.narrow_length are preferred as ends. Rafts of a
/// patch are separate mazes; only the raft with the most bubbles has a solution. There is no
/// solution if no two bubbles share a film.
Maze find_maze(const Frame& frame, const MazeRule& rule);

/// Counts of bubbles that describe a maze.
struct MazeStatistics {
    int solution = 0;   // number of bubbles that the solution visits
    int dead_ends = 0;  // number of bubbles with exactly one open film
    int branches = 0;   // number of bubbles with three or more open films
};

/// Returns the statistics of a maze. The entrance and the exit of a patch count as open films.
MazeStatistics measure(const Maze& maze, const Frame& frame);

}  // namespace foam::texgen
