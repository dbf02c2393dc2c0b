// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/draw.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace foam::texgen {
namespace {

constexpr int kDrawPixels = 200;

struct Drawn {
    Frame frame = test::fitted_frame(test::polydisperse_foam(60, 7), kDrawPixels, kDrawPixels);
    FoamRecord record{};
    MapOptions maps{};
    VectorOptions options{};

    Drawing of(VectorContent content) {
        FrameLayers layers({frame, record}, {kDrawPixels, kDrawPixels}, 1);
        return draw(layers, content, maps, options);
    }
};

const Layer* find_layer(const Drawing& drawing, const std::string& name) {
    for (const Layer& layer : drawing.layers) {
        if (layer.name == name) {
            return &layer;
        }
    }
    return nullptr;
}

double area_of(const Layer& layer) {
    double area = 0.0;
    for (const Shape& shape : layer.shapes) {
        for (const Chain& chain : shape.chains) {
            area += signed_area(chain);
        }
    }
    return area;
}

std::size_t arcs_in(const Layer& layer) {
    std::size_t arcs = 0;
    for (const Shape& shape : layer.shapes) {
        for (const Chain& chain : shape.chains) {
            arcs += chain.steps.size();
        }
    }
    return arcs;
}

TEST(Draw, AFoamHasBubblesAndFilms) {
    Drawn drawn;
    const Drawing drawing = drawn.of(VectorContent::Foam);
    EXPECT_DOUBLE_EQ(drawing.width, 100.0);
    ASSERT_NE(find_layer(drawing, "bubbles"), nullptr);
    EXPECT_EQ(find_layer(drawing, "bubbles")->shapes.size(), 60U);
    const Layer* const films = find_layer(drawing, "films");
    ASSERT_NE(films, nullptr);
    // albedo.film_width is 2 pixels, of 200 pixels on 100 mm.
    EXPECT_NEAR(films->style.stroke_width, 1.0, 1e-12);
    EXPECT_EQ(drawing.junctions.size(), drawn.frame.network.junction_count());
}

// The walls of width w and the rest of the bubbles fill the tile. For narrow walls, the area of the
// walls is w times the length of the films, apart from the junctions: at each of them, three walls
// overlap in the area sqrt(3)/4 w².
TEST(Draw, OutlinesOfFilmsHaveTheAreaOfTheWalls) {
    Drawn drawn;
    drawn.options.walls = VectorWalls::Outlines;
    drawn.options.wall_width = 0.2;
    const Drawing drawing = drawn.of(VectorContent::Foam);
    double length = 0.0;
    for (const FilmArc& arc : drawn.frame.arcs) {
        length += drawing.scale * arc_length(arc);
    }
    const double overlap = std::sqrt(3.0) / 4.0 * 0.04;
    const double expected =
        0.2 * length - overlap * static_cast<double>(drawn.frame.network.junction_count());
    EXPECT_NEAR(area_of(*find_layer(drawing, "films")) / expected, 1.0, 1e-4);
}

// All films except the open ones are walls of the maze. 60 rooms have 59 openings.
TEST(Draw, AMazeHasWallsAndAGround) {
    Drawn drawn;
    const Drawing drawing = drawn.of(VectorContent::Maze);
    EXPECT_EQ(find_layer(drawing, "bubbles"), nullptr);
    EXPECT_EQ(drawing.background, drawn.maps.maze.passage_color);
    drawn.options.wrap = VectorWrap::Whole;
    const Drawing whole = drawn.of(VectorContent::Maze);
    EXPECT_TRUE(whole.background.empty());
    EXPECT_NEAR(area_of(*find_layer(whole, "passages")), whole.width * whole.height, 1e-8);
    FrameLayers layers({drawn.frame, drawn.record}, {kDrawPixels, kDrawPixels}, 1);
    std::size_t walls = 0;
    for (const std::uint8_t open : layers.maze(maze_rule(drawn.maps.maze)).is_open) {
        walls += open == 0 ? 1 : 0;
    }
    EXPECT_EQ(walls, drawn.frame.network.film_count() - 59);
    EXPECT_GE(arcs_in(*find_layer(whole, "walls")), walls);
}

// Bubbles at the border of the tile extend beyond it on every side.
TEST(Draw, ThePageHoldsWholeBubbles) {
    Drawn drawn;
    const Drawing cut = drawn.of(VectorContent::Foam);
    EXPECT_EQ(cut.page_box().high, Vec2(cut.width, cut.height));
    drawn.options.wrap = VectorWrap::Whole;
    const Drawing whole = drawn.of(VectorContent::Foam);
    const Box page = whole.page_box();
    EXPECT_LT(page.low.maxCoeff(), 0.0);
    EXPECT_GT(page.high.x(), whole.width);
    EXPECT_GT(page.high.y(), whole.height);
    Box bubbles{whole.layers.front().shapes.front().chains.front().tail,
                whole.layers.front().shapes.front().chains.front().tail};
    for (const Shape& bubble : find_layer(whole, "bubbles")->shapes) {
        for (const Chain& chain : bubble.chains) {
            include(chain, bubbles);
        }
    }
    const double half_line = 0.5 * find_layer(whole, "films")->style.stroke_width;
    EXPECT_LT((bubbles.low - page.low - Vec2::Constant(half_line)).norm(), 1e-9);
    EXPECT_LT((page.high - bubbles.high - Vec2::Constant(half_line)).norm(), 1e-9);
}

TEST(Draw, TheSolutionIsALineOfArcs) {
    Drawn drawn;
    const Drawing drawing = drawn.of(VectorContent::MazeSolution);
    const Layer* const solution = find_layer(drawing, "solution");
    ASSERT_NE(solution, nullptr);
    EXPECT_EQ(solution->style.stroke, drawn.maps.maze.solution_color);
    EXPECT_GT(arcs_in(*solution), 4U);
}

// Films of a honeycomb are on the border of the tile, so that the solution crosses them there, in
// points between two arcs. An arc is shorter than a bubble.
TEST(Draw, AChainOfTheSolutionEndsAtTheBorder) {
    Drawn drawn{.frame = test::fitted_frame(honeycomb(4, 4), kDrawPixels, kDrawPixels)};
    int ends_on_border = 0;
    for (int seed = 1; seed <= 8; ++seed) {
        drawn.maps.maze.seed = seed;
        const Drawing drawing = drawn.of(VectorContent::MazeSolution);
        for (const Shape& shape : find_layer(drawing, "solution")->shapes) {
            const Chain& chain = shape.chains.front();
            ends_on_border += chain.head().x() == 0.0 || chain.head().x() == drawing.width ? 1 : 0;
            for (const DrawnArc& arc : arcs_of(chain)) {
                EXPECT_LT((arc.head - arc.tail).norm(), 0.25 * drawing.width);
            }
        }
    }
    EXPECT_GT(ends_on_border, 0);
}

TEST(Draw, OutlinesOfAMazeStayInTheTile) {
    Drawn drawn;
    drawn.options.walls = VectorWalls::Outlines;
    const Drawing drawing = drawn.of(VectorContent::MazeSolution);
    for (const char* const name : {"walls", "solution"}) {
        const Layer& layer = *find_layer(drawing, name);
        EXPECT_GT(area_of(layer), 0.0);
        EXPECT_LT(area_of(layer), drawing.width * drawing.height);
        for (const Chain& chain : layer.shapes[0].chains) {
            EXPECT_TRUE(chain.is_closed);
            for (const Chain::Step& step : chain.steps) {
                EXPECT_GE(step.head.minCoeff(), -1e-9);
                EXPECT_LE(step.head.maxCoeff(), 100.0 + 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace foam::texgen
