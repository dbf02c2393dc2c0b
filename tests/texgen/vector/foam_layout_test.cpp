// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/foam_layout.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

namespace foam::texgen {
namespace {

constexpr int kPixels = 200;
constexpr double kWidth = 50.0;  // millimeters

bool all_films(FilmId) {
    return true;
}

Frame torus_frame() {
    return test::fitted_frame(test::polydisperse_foam(60, 3), kPixels, kPixels);
}

Page page_of_torus(const Frame& frame) {
    return page_of(frame.domain, {kPixels, kPixels}, kWidth);
}

double area_of(const std::vector<Chain>& chains) {
    double area = 0.0;
    for (const Chain& chain : chains) {
        area += signed_area(chain);
    }
    return area;
}

// Returns the number of films that leave the tile, which a border of the tile cuts.
std::size_t crossing_films(const Frame& frame) {
    std::size_t count = 0;
    for (const FilmId film : frame.network.films()) {
        count += frame.network.offset(forward_side(film)) == LatticeOffset{} ? 0U : 1U;
    }
    return count;
}

TEST(FoamLayout, CutBubblesHaveTheirAreasAndFillTheTile) {
    const Frame frame = torus_frame();
    const Page page = page_of_torus(frame);
    const auto bubbles = FoamLayout(frame, page, VectorWrap::Cut).bubbles();
    double sum = 0.0;
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
        const double area = frame.bubbles[id_at<BubbleId>(k)].area * page.scale * page.scale;
        EXPECT_NEAR(area_of(bubbles[k]) / area, 1.0, 1e-12);
        sum += area_of(bubbles[k]);
        for (const Chain& chain : bubbles[k]) {
            for (const DrawnArc& arc : arcs_of(chain)) {
                EXPECT_GE(arc.head.minCoeff(), -1e-12);
                EXPECT_LE(arc.head.maxCoeff(), kWidth + 1e-12);
            }
        }
    }
    EXPECT_NEAR(sum, page.width * page.height, 1e-9);
}

TEST(FoamLayout, WholeBubblesHaveTheirAreasInOneChainWithACentroidInTheTile) {
    const Frame frame = torus_frame();
    const Page page = page_of_torus(frame);
    const auto bubbles = FoamLayout(frame, page, VectorWrap::Whole).bubbles();
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
        ASSERT_EQ(bubbles[k].size(), 1U);
        const double area = frame.bubbles[id_at<BubbleId>(k)].area * page.scale * page.scale;
        EXPECT_NEAR(area_of(bubbles[k]) / area, 1.0, 1e-12);
        EXPECT_EQ(page.domain.cell_of(centroid(bubbles[k][0])), LatticeOffset{});
        EXPECT_EQ(bubbles[k][0].steps.size(),
                  static_cast<std::size_t>(frame.network.sides(id_at<BubbleId>(k))));
    }
}

TEST(FoamLayout, EveryFilmIsDrawnOnce) {
    const Frame frame = torus_frame();
    const Page page = page_of_torus(frame);
    const auto lines = FoamLayout(frame, page, VectorWrap::Cut).lines(all_films);
    EXPECT_GE(lines.size(), frame.network.film_count() + crossing_films(frame));
    double length = 0.0;
    double expected = 0.0;
    for (const NetArc& line : lines) {
        length += arc_length(line.arc.arc());
    }
    for (const FilmId film : frame.network.films()) {
        expected += page.scale * arc_length(frame.arcs[film]);
    }
    EXPECT_NEAR(length, expected, 1e-9);
}

// A film is drawn on two sides of the tile if the bubbles beside it are. All bubbles of the
// honeycomb have six films, so the films of n whole bubbles are 6 n - (shared films).
TEST(FoamLayout, WholeBubblesHaveAllTheirFilms) {
    const Frame frame = torus_frame();
    const FoamLayout layout(frame, page_of_torus(frame), VectorWrap::Whole);
    const auto lines = layout.lines(all_films);
    // Counts the films of each bubble: the same arc, at the same position up to rounding.
    std::set<std::pair<long, long>> middles;
    for (const NetArc& line : lines) {
        const Vec2 middle = 0.5 * (line.arc.tail + line.arc.head);
        middles.insert({std::lround(1e6 * middle.x()), std::lround(1e6 * middle.y())});
    }
    EXPECT_EQ(middles.size(), lines.size());  // none is drawn twice in one place
    for (const auto& outlines : layout.bubbles()) {
        for (const DrawnArc& arc : arcs_of(outlines.front())) {
            const Vec2 middle = 0.5 * (arc.tail + arc.head);
            EXPECT_TRUE(
                middles.contains({std::lround(1e6 * middle.x()), std::lround(1e6 * middle.y())}));
        }
    }
}

TEST(FoamLayout, ChainsContainEveryArcOnce) {
    const Frame frame = torus_frame();
    for (const VectorWrap wrap : {VectorWrap::Cut, VectorWrap::Whole}) {
        const auto lines = FoamLayout(frame, page_of_torus(frame), wrap).lines(all_films);
        const std::vector<Chain> chains = joined(lines);
        std::size_t arcs = 0;
        for (const Chain& chain : chains) {
            arcs += chain.steps.size();
        }
        EXPECT_EQ(arcs, lines.size());
        EXPECT_LT(chains.size(), lines.size());
    }
}

// A patch has each film once, and two arcs per lone bubble.
TEST(FoamLayout, APatchHasAllFilmsAndCircles) {
    Foam foam = test::patch_foam(20, 5);
    foam.lone_bubbles.push_back({foam.next_identity, {20.0, 0.0}, 3.0});
    const Frame frame = snapshot(foam, 1);
    const Page page =
        page_of(frame.domain, {kPixels, kPixels, 0, 0, View{{0.0, 0.0}, 4.0}}, kWidth);
    const FoamLayout layout(frame, page, VectorWrap::Cut);
    EXPECT_EQ(layout.lines(all_films).size(), frame.network.film_count() + 2);
    const auto bubbles = layout.bubbles();
    ASSERT_EQ(bubbles.size(), frame.bubbles.size() + 1);
    EXPECT_NEAR(area_of(bubbles.back()), 3.0 * page.scale * page.scale, 1e-12);
    // 4 pixels per foam unit, and 0.25 mm per pixel; the origin is in the middle of the page.
    EXPECT_NEAR(page.scale, 1.0, 1e-15);
    EXPECT_NEAR((centroid(bubbles.back()[0]) - Vec2(45.0, 25.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
