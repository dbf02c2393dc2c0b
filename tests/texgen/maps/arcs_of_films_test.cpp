// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arcs_of_films.h"

#include "tests/texgen/maps/map_subjects.h"
#include "texgen/raster/distance/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ArcsOfFilms, AreTheChosenFilmsAndTheCirclesOfLoneBubbles) {
    const test::MapSubject& patch = test::patch_subject();
    const std::size_t circles = 2 * patch.frame.lone_bubbles.size();
    EXPECT_EQ(circles, 2U);
    EXPECT_EQ(
        arcs_of_films(patch.frame, test::patch_grid(64), 1, [](FilmId) { return false; }).size(),
        circles);
    std::vector<FilmId> films;
    for (const FilmId film : patch.frame.network.films()) {
        films.push_back(film);
    }
    EXPECT_EQ(
        arcs_of_films(patch.frame, test::patch_grid(64), 1, [](FilmId) { return true; }).size(),
        films.size() + circles);
    const std::vector<PlacedArc> one = arcs_of_films(
        patch.frame, test::patch_grid(64), 1, [&](FilmId film) { return film == films[3]; });
    ASSERT_EQ(one.size(), 1 + circles);
    const double scale = pixels_per_unit(test::patch_grid(64), patch.frame.domain);
    const HalfEdgeId side = forward_side(films[3]);
    EXPECT_EQ(one.front().tail, patch.frame.positions[patch.frame.network.tail(side)]);
    EXPECT_LT((one.front().arc.chord - scale * patch.frame.arc(side).chord).norm(), 1e-9);
}

// Both half circles around a lone bubble have their ends on its boundary, and their middles are
// above and below its center.
TEST(ArcsOfFilms, ALoneBubbleIsTwoHalfCircles) {
    const test::MapSubject& patch = test::patch_subject();
    const double scale = pixels_per_unit(test::patch_grid(64), patch.frame.domain);
    const LoneBubble& bubble = patch.frame.lone_bubbles.front();
    const double radius = std::sqrt(bubble.target_area / std::numbers::pi);
    const std::vector<PlacedArc> circle =
        arcs_of_films(patch.frame, test::patch_grid(64), 1, [](FilmId) { return false; });
    ASSERT_EQ(circle.size(), 2U);
    EXPECT_GT((circle[0].tail - circle[1].tail).norm(), radius);
    for (const PlacedArc& half : circle) {
        const Vec2 middle = half.tail + halves(half.arc)[0].chord / scale;
        const Vec2 head = half.tail + half.arc.chord / scale;
        const double up = half.tail.x() > bubble.center.x() ? 1.0 : -1.0;
        EXPECT_NEAR((half.tail - bubble.center).norm(), radius, 1e-9 * radius);
        EXPECT_NEAR((head - bubble.center).norm(), radius, 1e-9 * radius);
        EXPECT_LT((middle - bubble.center - Vec2(0.0, up * radius)).norm(), 1e-9 * radius);
    }
}

}  // namespace
}  // namespace foam::texgen
