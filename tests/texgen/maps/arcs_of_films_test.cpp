// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arcs_of_films.h"

#include "tests/texgen/maps/map_subjects.h"

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
    const std::vector<PlacedArc> halves =
        arcs_of_films(patch.frame, test::patch_grid(64), 1, [](FilmId) { return false; });
    for (const PlacedArc& half : halves) {
        EXPECT_NEAR((half.tail - bubble.center).norm(), radius, 1e-9 * radius);
        for (const double angle : {0.3, 1.2, 2.9, 4.4, 6.0}) {
            const Vec2 direction(std::cos(angle), std::sin(angle));
            const Vec2 point = scale * (bubble.center + radius * direction - half.tail);
            const bool is_above = direction.y() > 0.0;
            const bool covers = is_above == (half.tail.x() > bubble.center.x());
            EXPECT_EQ(nearest_on_arc(half.arc, point).distance < 1e-6, covers) << angle;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
