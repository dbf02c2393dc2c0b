// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze_graph.h"

#include "core/geometry/film_arc.h"
#include "core/geometry/splitmix64.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace foam::texgen {

namespace {

// The spanning tree is built by Kruskal's algorithm: films are visited in the order of their
// weights, all narrow films last. A film is opened if no path of open films connects the bubbles on
// its sides yet. Groups of connected bubbles are kept in a disjoint-set forest. The longest path in
// a tree is found by two breadth-first searches. The bubble farthest from an arbitrary bubble is
// one end of the path. The bubble farthest from this end is the other end.

// A disjoint-set forest with union by size and path halving (R. E. Tarjan and J. van Leeuwen,
// "Worst-case analysis of set union algorithms", 1984).
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parents_(count), sizes_(count, 1) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }

    std::size_t root_of(std::size_t element) {
        while (parents_[element] != element) {
            parents_[element] = parents_[parents_[element]];
            element = parents_[element];
        }
        return element;
    }

    // Returns the number of elements in the set of an element.
    std::size_t size_of(std::size_t element) { return sizes_[root_of(element)]; }

    // Joins the sets of two elements. Returns false if they were in one set already.
    bool join(std::size_t a, std::size_t b) {
        a = root_of(a);
        b = root_of(b);
        if (a == b) {
            return false;
        }
        if (sizes_[a] < sizes_[b]) {
            std::swap(a, b);
        }
        parents_[b] = a;
        sizes_[a] += sizes_[b];
        return true;
    }

  private:
    std::vector<std::size_t> parents_;
    std::vector<std::size_t> sizes_;  // the size of each set, at the index of its root
};

// Returns a number in [0, 1): the upper 53 bits of a hash of the seed, the smaller and the larger
// identity, in this order.
double number_of_pair(std::int64_t seed, BubbleIdentity one, BubbleIdentity other) {
    const auto [low, high] = std::minmax(one, other);
    const std::uint64_t bits = splitmix64(
        splitmix64(splitmix64(static_cast<std::uint64_t>(seed)) ^ static_cast<std::uint64_t>(low)) ^
        static_cast<std::uint64_t>(high));
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

using OpenFilms = Indexed<FilmId, std::uint8_t>;

// A film between two different bubbles.
struct Wall {
    FilmId film;
    bool is_narrow;  // MazeRule::narrow_length
    double weight;   // the spanning tree opens films of small weight first, but narrow films last
    // A random number in [0, 1), which is also a part of the weight. Loops are made by opening
    // films in the order of these numbers, but narrow films last.
    double number;
};

// Returns true if a film is narrow (MazeRule::narrow_length). A film is narrow if it is shorter
// than `width` or if a bubble beside it has a smaller area than a circle with this diameter.
bool is_narrow(const Frame& frame, FilmId film, double width) {
    const HalfEdgeId side = forward_side(film);
    const double area = std::min(frame.bubbles[frame.network.left(side)].area,
                                 frame.bubbles[frame.network.right(side)].area);
    return arc_length(frame.arcs[film]) < width || 4.0 * area < std::numbers::pi * width * width;
}

// Returns the films between two different bubbles, without the outer films of a patch.
std::vector<Wall> walls_of(const Frame& frame, const MazeRule& rule) {
    const Network& network = frame.network;
    std::vector<Wall> walls;
    double sum = 0.0;
    for (const FilmId film : network.films()) {
        const HalfEdgeId side = forward_side(film);
        const BubbleId left = network.left(side);
        const BubbleId right = network.right(side);
        if (left == right || network.is_outer(film)) {
            continue;
        }
        const FrameBubble& a = frame.bubbles[left];
        const FrameBubble& b = frame.bubbles[right];
        const double step = std::abs(a.pressure - b.pressure);
        walls.push_back({film,
                         is_narrow(frame, film, rule.narrow_length),
                         step,
                         number_of_pair(rule.seed, a.identity, b.identity)});
        sum += step;
    }
    // Differences of pressure are scaled so that their mean is 0.5, the mean of the random numbers.
    // If the mean is so small that it may be an error of the solver, all differences count as 0.
    constexpr double kMaxError = 1e-8;  // in film tensions per foam unit of length
    const double mean = sum / std::max(static_cast<double>(walls.size()), 1.0);
    const double scale = mean > kMaxError * frame.film_tension ? 0.5 / mean : 0.0;
    for (Wall& wall : walls) {
        wall.weight = (1.0 - rule.chance) * scale * wall.weight + rule.chance * wall.number;
    }
    return walls;
}

// The spanning tree of a frame.
struct SpanningTree {
    OpenFilms is_open;
    std::vector<Wall> closed;  // all films of walls_of that are not open
    // A bubble of the torus, or of the raft with the most bubbles; kNone if no two share a film.
    BubbleId in_largest_raft = kNone<BubbleId>;
};

// Opens films until exactly one path connects any two bubbles of a torus, or of a raft of a patch.
SpanningTree spanning_tree(const Frame& frame, const MazeRule& rule) {
    std::vector<Wall> walls = walls_of(frame, rule);
    std::sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) {
        return std::tuple(a.is_narrow, a.weight, a.film) <
               std::tuple(b.is_narrow, b.weight, b.film);
    });
    SpanningTree tree{OpenFilms(frame.network.film_slots(), 0), {}, kNone<BubbleId>};
    DisjointSets connected(frame.network.bubble_slots());
    for (const Wall& wall : walls) {
        const HalfEdgeId side = forward_side(wall.film);
        if (connected.join(index_of(frame.network.left(side)),
                           index_of(frame.network.right(side)))) {
            tree.is_open[wall.film] = 1;
        } else {
            tree.closed.push_back(wall);
        }
    }
    std::size_t largest = 1;
    for (const BubbleId bubble : frame.network.bubbles()) {
        if (connected.size_of(index_of(bubble)) > largest) {
            largest = connected.size_of(index_of(bubble));
            tree.in_largest_raft = bubble;
        }
    }
    return tree;
}

// Returns the open films of a maze: the open films of the tree, and the fraction `loops` of its
// closed films. Films that are not narrow are opened first, in the order of their random numbers.
OpenFilms with_loops(SpanningTree tree, double loops) {
    std::sort(tree.closed.begin(), tree.closed.end(), [](const Wall& a, const Wall& b) {
        return std::tuple(a.is_narrow, a.number, a.film) <
               std::tuple(b.is_narrow, b.number, b.film);
    });
    const auto extra =
        static_cast<std::size_t>(std::lround(loops * static_cast<double>(tree.closed.size())));
    for (std::size_t k = 0; k < std::min(extra, tree.closed.size()); ++k) {
        tree.is_open[tree.closed[k].film] = 1;
    }
    return std::move(tree.is_open);
}

// A breadth-first search through the open films, from one bubble.
class Search {
  public:
    Search(const Frame& frame, const OpenFilms& is_open, BubbleId from)
        : network_(frame.network),
          reached_by_(network_.bubble_slots(), kNone<HalfEdgeId>),
          order_{from} {
        Indexed<BubbleId, std::uint8_t> is_reached(network_.bubble_slots(), 0);
        is_reached[from] = 1;
        for (std::size_t k = 0; k < order_.size(); ++k) {
            for (const HalfEdgeId side : network_.around(order_[k])) {
                const BubbleId next = network_.right(side);
                if (is_open[film_of(side)] != 0 && next != network_.ghost() &&
                    is_reached[next] == 0) {
                    is_reached[next] = 1;
                    reached_by_[next] = side;
                    order_.push_back(next);
                }
            }
        }
    }

    // Returns the bubbles that can be reached, nearest first.
    const std::vector<BubbleId>& order() const { return order_; }

    // Returns the films on the path to a bubble that can be reached.
    std::vector<HalfEdgeId> path_to(BubbleId bubble) const {
        std::vector<HalfEdgeId> path;
        for (; reached_by_[bubble] != kNone<HalfEdgeId>; bubble = network_.left(path.back())) {
            path.push_back(reached_by_[bubble]);
        }
        std::reverse(path.begin(), path.end());
        return path;
    }

  private:
    const Network& network_;
    Indexed<BubbleId, HalfEdgeId> reached_by_;  // the half-edge through which a bubble is entered
    std::vector<BubbleId> order_;
};

// Returns the longest outer film of a bubble, as a side of this bubble, or kNone if the bubble has
// no outer film.
HalfEdgeId longest_outer_side(const Frame& frame, BubbleId bubble) {
    HalfEdgeId longest = kNone<HalfEdgeId>;
    double length = -1.0;
    for (const HalfEdgeId side : frame.network.around(bubble)) {
        const double arc = arc_length(frame.arc(side));
        if (frame.network.is_outer(film_of(side)) && arc > length) {
            longest = side;
            length = arc;
        }
    }
    return longest;
}

// Returns the suitability of a bubble as an end of the solution. On a torus it is 2. On a patch it
// is 0 for a bubble without outer films, 1 if the longest outer film is shorter than
// rule.narrow_length, otherwise 2.
int rank_as_end(const Frame& frame, const MazeRule& rule, BubbleId bubble) {
    if (!frame.domain.is_plane()) {
        return 2;
    }
    const HalfEdgeId side = longest_outer_side(frame, bubble);
    if (side == kNone<HalfEdgeId>) {
        return 0;
    }
    return arc_length(frame.arc(side)) < rule.narrow_length ? 1 : 2;
}

// Returns the farthest of the bubbles of a search that have the highest rank_as_end. The bubble in
// which the search begins is not considered.
BubbleId farthest_end(const Frame& frame, const MazeRule& rule, const Search& search) {
    return *std::max_element(
        search.order().rbegin(), search.order().rend() - 1, [&](BubbleId farther, BubbleId nearer) {
            return rank_as_end(frame, rule, farther) < rank_as_end(frame, rule, nearer);
        });
}

}  // namespace

Maze find_maze(const Frame& frame, const MazeRule& rule) {
    const SpanningTree tree = spanning_tree(frame, rule);
    Maze maze;
    maze.is_open = with_loops(tree, rule.loops);
    if (tree.in_largest_raft == kNone<BubbleId>) {
        return maze;
    }
    const Search from_any(frame, tree.is_open, tree.in_largest_raft);
    const BubbleId start = farthest_end(frame, rule, from_any);
    const BubbleId end = farthest_end(frame, rule, Search(frame, tree.is_open, start));
    maze.solution = Search(frame, maze.is_open, start).path_to(end);
    if (frame.domain.is_plane()) {
        maze.solution.insert(maze.solution.begin(), twin(longest_outer_side(frame, start)));
        maze.solution.push_back(longest_outer_side(frame, end));
        maze.is_open[film_of(maze.solution.front())] = 1;
        maze.is_open[film_of(maze.solution.back())] = 1;
    }
    return maze;
}

MazeStatistics measure(const Maze& maze, const Frame& frame) {
    MazeStatistics statistics;
    const int films = static_cast<int>(maze.solution.size());
    statistics.solution = films == 0 ? 0 : films + (frame.domain.is_plane() ? -1 : 1);
    for (const BubbleId bubble : frame.network.bubbles()) {
        const std::vector<HalfEdgeId> sides = frame.network.around(bubble);
        const auto open = std::count_if(sides.begin(), sides.end(), [&](HalfEdgeId side) {
            return maze.is_open[film_of(side)] != 0;
        });
        statistics.dead_ends += open == 1 ? 1 : 0;
        statistics.branches += open > 2 ? 1 : 0;
    }
    return statistics;
}

}  // namespace foam::texgen
