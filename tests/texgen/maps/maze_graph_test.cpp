// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/maze_graph.h"

#include "core/geometry/film_arc.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace foam::texgen {
namespace {

Frame torus(std::uint64_t seed = 3) {
    return snapshot(test::polydisperse_foam(60, seed), 1);
}

Frame patch() {
    return snapshot(test::patch_foam(50, 2), 1);
}

std::vector<FilmId> open_films(const Frame& frame, const Maze& maze) {
    std::vector<FilmId> open;
    for (const FilmId film : frame.network.films()) {
        if (maze.is_open[film] != 0) {
            open.push_back(film);
        }
    }
    return open;
}

// Returns the distance of every bubble from one bubble, in films, or -1 if it cannot be reached.
std::vector<int> distances_from(const Frame& frame, const Maze& maze, BubbleId from) {
    std::vector<int> distance(frame.network.bubble_slots(), -1);
    distance[index_of(from)] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const FilmId film : open_films(frame, maze)) {
            const HalfEdgeId side = forward_side(film);
            for (const HalfEdgeId h : {side, twin(side)}) {
                const int before = distance[index_of(frame.network.left(h))];
                int& after = distance[index_of(frame.network.right(h))];
                if (before >= 0 && (after < 0 || after > before + 1) &&
                    frame.network.right(h) != frame.network.ghost()) {
                    after = before + 1;
                    changed = true;
                }
            }
        }
    }
    return distance;
}

double sum_of_pressure_steps(const Frame& frame, const Maze& maze) {
    double sum = 0.0;
    for (const FilmId film : open_films(frame, maze)) {
        const HalfEdgeId side = forward_side(film);
        sum += std::abs(frame.bubbles[frame.network.left(side)].pressure -
                        frame.bubbles[frame.network.right(side)].pressure);
    }
    return sum;
}

// A connected graph with one edge less than nodes has exactly one way between any two nodes.
TEST(MazeGraph, ExactlyOneWayLeadsFromAnyBubbleToAnyOther) {
    for (const double chance : {0.0, 0.4, 1.0}) {
        const Frame frame = torus();
        const Maze maze = find_maze(frame, {.chance = chance});
        EXPECT_EQ(open_films(frame, maze).size(), frame.network.bubble_count() - 1);
        const std::vector<int> distance = distances_from(frame, maze, id_at<BubbleId>(0));
        EXPECT_EQ(std::count(distance.begin(), distance.end(), -1), 0);
    }
}

TEST(MazeGraph, OpensTheGivenFractionOfTheWalls) {
    const Frame frame = torus();
    const std::size_t tree = open_films(frame, find_maze(frame, {})).size();
    const std::size_t walls = frame.network.film_count() - tree;
    EXPECT_EQ(open_films(frame, find_maze(frame, {.loops = 0.25})).size(),
              tree + static_cast<std::size_t>(std::lround(0.25 * static_cast<double>(walls))));
    EXPECT_EQ(open_films(frame, find_maze(frame, {.loops = 1.0})).size(),
              frame.network.film_count());
}

TEST(MazeGraph, PassagesFollowThePressureUnlessChanceDecides) {
    const Frame frame = torus();
    const double by_pressure = sum_of_pressure_steps(frame, find_maze(frame, {.chance = 0.0}));
    const double mixed = sum_of_pressure_steps(frame, find_maze(frame, {.chance = 0.5}));
    const double by_chance = sum_of_pressure_steps(frame, find_maze(frame, {.chance = 1.0}));
    EXPECT_LT(by_pressure, mixed);
    EXPECT_LT(mixed, by_chance);
}

// Returns the number of open films that are shorter than a length.
int open_and_shorter(const Frame& frame, const Maze& maze, double length) {
    const std::vector<FilmId> open = open_films(frame, maze);
    return static_cast<int>(std::count_if(open.begin(), open.end(), [&](FilmId film) {
        return arc_length(frame.arcs[film]) < length;
    }));
}

TEST(MazeGraph, NarrowFilmsAreOpenedLast) {
    const Frame frame = torus();
    constexpr double kNarrow = 0.3;
    EXPECT_GT(open_and_shorter(frame, find_maze(frame, {.chance = 1.0}), kNarrow), 3);
    EXPECT_EQ(open_and_shorter(
                  frame, find_maze(frame, {.chance = 1.0, .narrow_length = kNarrow}), kNarrow),
              0);
}

TEST(MazeGraph, DependsOnTheSeedIfChanceDecides) {
    const Frame frame = torus();
    EXPECT_NE(find_maze(frame, {.chance = 1.0, .seed = 1}).is_open,
              find_maze(frame, {.chance = 1.0, .seed = 2}).is_open);
    EXPECT_EQ(find_maze(frame, {.chance = 0.0, .seed = 1}).is_open,
              find_maze(frame, {.chance = 0.0, .seed = 2}).is_open);
}

TEST(MazeGraph, TheSolutionOfATorusIsTheLongestWay) {
    const Frame frame = torus();
    const Maze maze = find_maze(frame, {});
    int longest = 0;
    for (const BubbleId bubble : frame.network.bubbles()) {
        const std::vector<int> distance = distances_from(frame, maze, bubble);
        longest = std::max(longest, *std::max_element(distance.begin(), distance.end()));
    }
    EXPECT_EQ(static_cast<int>(maze.solution.size()), longest);
}

void expect_way(const Frame& frame, const Maze& maze) {
    ASSERT_FALSE(maze.solution.empty());
    std::set<BubbleId> visited;
    for (std::size_t k = 0; k < maze.solution.size(); ++k) {
        EXPECT_NE(maze.is_open[film_of(maze.solution[k])], 0);
        EXPECT_TRUE(visited.insert(frame.network.left(maze.solution[k])).second);
        if (k > 0) {
            EXPECT_EQ(frame.network.right(maze.solution[k - 1]),
                      frame.network.left(maze.solution[k]));
        }
    }
}

TEST(MazeGraph, TheSolutionPassesOpenFilmsAndNoBubbleTwice) {
    for (const double loops : {0.0, 0.3}) {
        const Frame on_torus = torus();
        expect_way(on_torus, find_maze(on_torus, {.loops = loops}));
        const Frame on_patch = patch();
        expect_way(on_patch, find_maze(on_patch, {.loops = loops}));
    }
}

TEST(MazeGraph, LoopsDoNotLengthenTheSolution) {
    const Frame frame = torus();
    EXPECT_LT(find_maze(frame, {.loops = 0.5}).solution.size(),
              find_maze(frame, {}).solution.size());
}

TEST(MazeGraph, APatchHasAnEntranceAndAnExit) {
    const Frame frame = patch();
    const Maze maze = find_maze(frame, {});
    EXPECT_EQ(frame.network.left(maze.solution.front()), frame.network.ghost());
    EXPECT_EQ(frame.network.right(maze.solution.back()), frame.network.ghost());
    const std::vector<FilmId> open = open_films(frame, maze);
    EXPECT_EQ(
        std::count_if(
            open.begin(), open.end(), [&](FilmId film) { return frame.network.is_outer(film); }),
        2);
    EXPECT_EQ(open.size(), frame.network.bubble_count() + 1);
}

// With walls so wide that every film is narrow, the entrance and the exit are still two films.
TEST(MazeGraph, TheEntranceIsNeverTheExit) {
    const Frame frame = patch();
    for (const double narrow : {0.5, 1.0, 1.3, 1.6, 10.0}) {
        const Maze maze = find_maze(frame, {.narrow_length = narrow});
        EXPECT_NE(film_of(maze.solution.front()), film_of(maze.solution.back())) << narrow;
        EXPECT_GE(maze.solution.size(), 3U);
    }
}

TEST(MazeGraph, WithoutTwoNeighborsThereIsNoSolution) {
    const Frame frame = snapshot(test::single_bubble(), 1);
    EXPECT_TRUE(find_maze(frame, {}).solution.empty());
    EXPECT_EQ(measure(find_maze(frame, {}), frame).solution, 0);
}

// In a tree, every branch of a bubble beyond the second ends in one more dead end.
TEST(MazeGraph, MeasuresDeadEndsAndBranches) {
    const Frame frame = torus();
    const Maze maze = find_maze(frame, {});
    const MazeStatistics statistics = measure(maze, frame);
    EXPECT_EQ(statistics.solution, static_cast<int>(maze.solution.size()) + 1);
    std::vector<int> open(frame.network.bubble_slots(), 0);
    for (const FilmId film : open_films(frame, maze)) {
        ++open[index_of(frame.network.left(forward_side(film)))];
        ++open[index_of(frame.network.right(forward_side(film)))];
    }
    int further = 0;
    for (const int count : open) {
        further += std::max(count - 2, 0);
    }
    EXPECT_EQ(statistics.dead_ends, further + 2);
    EXPECT_EQ(statistics.branches,
              std::count_if(open.begin(), open.end(), [](int count) { return count > 2; }));
}

}  // namespace
}  // namespace foam::texgen
