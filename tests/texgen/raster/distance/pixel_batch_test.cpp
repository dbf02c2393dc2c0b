// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/pixel_batch.h"

#include "tests/support/simd_levels.h"
#include "texgen/raster/distance/arc_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foam::texgen {
namespace {

// Fills a batch with 20 x 20 pixels, in spans of different lengths.
void add_pixels(PixelBatch& batch) {
    batch.clear(Vec2(10.0, 10.0));
    for (int row = 0; row < 20; ++row) {
        batch.add_span(0, row, row + 1);
        if (row < 19) {
            batch.add_span(row + 1, row, 19 - row);
        }
    }
}

template <class Check>
void for_each_pixel(const PixelBatch& batch, const Check& check) {
    for (const PixelBatch::Span& span : batch.spans()) {
        for (std::uint32_t k = 0; k < span.count; ++k) {
            const Vec2 center(span.column + static_cast<int>(k) + 0.5, span.row + 0.5);
            check(center, std::size_t{span.first + k});
        }
    }
}

ArcFunctions functions_of(const PixelArc& arc, const Vec2& tail, const Vec2& middle) {
    const std::vector<DistanceArc> arcs{{tail, arc}};
    ArcView view;
    view.evaluate(arcs, middle);
    return view.arc_functions(0);
}

// Distances are measured from a horizontal segment and from a point. Pixels between the ends of the
// segment face it. For other pixels only the point counts.
TEST(PixelBatch, TakesTheNearestOfArcsAndPoints) {
    at_every_simd_level([] {
        PixelBatch batch;
        add_pixels(batch);
        const Vec2 middle = batch.middle();
        const std::vector<ArcFunctions> arcs{
            functions_of({{8.0, 0.0}, 1.0, 0.0}, {6.0, -2.0}, middle)};
        const Vec2 point(3.0, 12.0);
        ASSERT_TRUE(batch.measure(arcs, std::vector<Vec2>{point - middle}, true));
        for_each_pixel(batch, [&](const Vec2& at, std::size_t k) {
            const bool faces = at.x() > 6.0 && at.x() < 14.0;
            const double to_point = (at - point).norm();
            const bool is_arc = faces && at.y() + 2.0 < to_point;
            ASSERT_NEAR(batch.distance()[k], is_arc ? at.y() + 2.0 : to_point, 1e-5);
            const Vec2 away = is_arc ? Vec2(0.0, 1.0) : Vec2((at - point) / to_point);
            ASSERT_NEAR(batch.gradient_x()[k], away.x(), 1e-5);
            ASSERT_NEAR(batch.gradient_y()[k], away.y(), 1e-5);
        });
    });
}

TEST(PixelBatch, HasTheSameDistancesWithAndWithoutGradients) {
    at_every_simd_level([] {
        PixelBatch batch;
        add_pixels(batch);
        const std::vector<ArcFunctions> arcs{
            functions_of({{30.0, 1.0}, 0.8, 0.6}, {-5.0, 3.0}, batch.middle()),
            functions_of({{2.0, 30.0}, 0.9, -std::sqrt(0.19)}, {4.0, -5.0}, batch.middle())};
        const std::vector<Vec2> points{{-3.0, 4.0}};
        batch.measure(arcs, points, false);
        const PixelBatch::Values plain = batch.distance();
        batch.measure(arcs, points, true);
        for_each_pixel(
            batch, [&](const Vec2&, std::size_t k) { ASSERT_EQ(batch.distance()[k], plain[k]); });
    });
}

TEST(PixelBatch, ReportsPixelsThatFaceNoArc) {
    at_every_simd_level([] {
        PixelBatch batch;
        add_pixels(batch);
        const std::vector<ArcFunctions> arcs{
            functions_of({{8.0, 0.0}, 1.0, 0.0}, {6.0, -2.0}, batch.middle())};
        EXPECT_FALSE(batch.measure(arcs, {}, true));
        for_each_pixel(batch, [&](const Vec2& at, std::size_t k) {
            ASSERT_EQ(std::isinf(batch.distance()[k]), at.x() < 6.0 || at.x() > 14.0);
        });
    });
}

// The films are two parallel lines, far longer than the distance between them. The smooth distance
// s follows from the distances a and b from the lines: 1/s² = 1/a² + 1/b².
TEST(PixelBatch, JoinsFilmsSmoothly) {
    at_every_simd_level([] {
        PixelBatch batch;
        add_pixels(batch);
        const std::vector<DistanceArc> films{{{-1e4, -1.0}, {{2e4, 0.0}, 1.0, 0.0}},
                                             {{1e4, 23.0}, {{-2e4, 0.0}, 1.0, 0.0}}};
        ArcView view;
        view.evaluate(films, batch.middle());
        const std::vector<ArcFunctions> arcs{view.arc_functions(0), view.arc_functions(1)};
        ASSERT_TRUE(batch.measure(arcs, {}, true));
        const bool all_are_smooth = batch.measure_smooth(
            std::vector<FilmFunctions>{view.film_functions(0), view.film_functions(1)}, true);
        EXPECT_TRUE(all_are_smooth);
        for_each_pixel(batch, [&](const Vec2& at, std::size_t k) {
            const double a = at.y() + 1.0;
            const double b = 23.0 - at.y();
            const double s = 1.0 / std::sqrt(1.0 / (a * a) + 1.0 / (b * b));
            ASSERT_NEAR(batch.smooth()[k], s, 1e-4);
            ASSERT_NEAR(batch.smooth_x()[k], 0.0, 1e-4);
            const double slope = s * s * s * (1.0 / (a * a * a) - 1.0 / (b * b * b));
            ASSERT_NEAR(batch.smooth_y()[k], slope, 1e-4);
        });
    });
}

TEST(PixelBatch, HasTheDistanceWhereThereIsNoFilm) {
    PixelBatch batch;
    add_pixels(batch);
    batch.measure({}, std::vector<Vec2>{{1.0, 2.0}}, true);
    EXPECT_FALSE(batch.measure_smooth({}, true));
    for_each_pixel(batch, [&](const Vec2&, std::size_t k) {
        ASSERT_EQ(batch.smooth()[k], batch.distance()[k]);
        ASSERT_EQ(batch.smooth_x()[k], batch.gradient_x()[k]);
        ASSERT_EQ(batch.smooth_y()[k], batch.gradient_y()[k]);
    });
}

}  // namespace
}  // namespace foam::texgen
