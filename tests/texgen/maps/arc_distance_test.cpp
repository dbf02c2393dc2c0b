// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include "core/foam/random.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

// Returns the distance from a point to an arc that begins at the origin. If the ray from the center
// of the circle to the point crosses the arc, it is the distance from the circle, otherwise that
// from the nearer end.
double exact_distance(const FilmArc& arc, const Vec2& point) {
    const double to_ends = std::min(point.norm(), (point - arc.chord).norm());
    const double sine = std::sin(arc.half_angle);
    if (std::abs(sine) < 1e-9 || arc.chord.isZero(0.0)) {
        const double along = point.dot(arc.chord) / std::max(arc.chord.squaredNorm(), 1e-300);
        return along < 0.0 || along > 1.0 ? to_ends : (point - along * arc.chord).norm();
    }
    const double radius = 0.5 * arc.chord.norm() / sine;
    const Vec2 center =
        0.5 * arc.chord + radius * std::cos(arc.half_angle) * turned_left(arc.chord.normalized());
    const Vec2 from_center = point - center;
    const double turned =
        std::atan2(cross(Vec2(-center), from_center), Vec2(-center).dot(from_center));
    const double left = arc.half_angle > 0.0 ? turned : -turned;  // in the direction of the arc
    const double angle = left < 0.0 ? left + 2.0 * std::numbers::pi : left;
    const bool crosses = angle <= 2.0 * std::abs(arc.half_angle);
    return crosses ? std::abs(from_center.norm() - std::abs(radius)) : to_ends;
}

// An image of one arc in the plane. The arc begins at the given position, in pixels.
ArcDistances distances_to_arc(const PixelArc& arc, const Vec2& tail, double reach) {
    constexpr int kSide = 48;
    const RasterGrid grid{kSide, kSide, 0, 0, View{Vec2::Constant(0.5 * kSide), 1.0}};
    const std::vector<PlacedArc> arcs = {{tail, arc}};
    return distances_to_arcs(arcs, grid, kPlane, {reach, true}, 2);
}

TEST(ArcDistance, IsTheDistanceToTheNearestPointOfTheArc) {
    const Vec2 tail(17.0, 19.0);
    for (const double half_angle : {-2.9, -1.6, -0.7, -0.01, 0.02, 0.9, 1.5, 2.0, 3.0}) {
        const FilmArc arc{{12.0, 5.0}, half_angle};
        const Image<float> image = distances_to_arc(pixel_arc(arc), tail, 100.0).distance;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const Vec2 point = Vec2(x + 0.5, y + 0.5) - tail;
                EXPECT_NEAR(image.pixel(x, y)[0], exact_distance(arc, point), 1e-4)
                    << "half angle " << half_angle << ", point " << point.transpose();
            }
        }
    }
}

TEST(ArcDistance, IsExactForAStraightLine) {
    const Image<float> image =
        distances_to_arc({{10.0, 0.0}, 1.0, 0.0}, {20.5, 20.5}, 100.0).distance;
    EXPECT_EQ(image.pixel(24, 23)[0], 3.0F);
    EXPECT_EQ(image.pixel(24, 17)[0], 3.0F);
    EXPECT_EQ(image.pixel(33, 24)[0], 5.0F);
    EXPECT_EQ(image.pixel(17, 16)[0], 5.0F);
}

TEST(ArcDistance, AnArcWithoutLengthIsAPoint) {
    const Image<float> image =
        distances_to_arc({{0.0, 0.0}, 1.0, 0.0}, {20.5, 20.5}, 100.0).distance;
    EXPECT_EQ(image.pixel(23, 24)[0], 5.0F);
    EXPECT_EQ(image.pixel(20, 20)[0], 0.0F);
}

TEST(ArcDistance, IsInfiniteBeyondTheReach) {
    const PixelArc arc = pixel_arc({{12.0, 5.0}, 0.9});
    const ArcDistances all = distances_to_arc(arc, {17.0, 19.0}, 100.0);
    const ArcDistances near = distances_to_arc(arc, {17.0, 19.0}, 6.5);
    for (int y = 0; y < near.distance.height(); ++y) {
        for (int x = 0; x < near.distance.width(); ++x) {
            const float distance = all.distance.pixel(x, y)[0];
            if (distance <= 6.5F) {
                EXPECT_EQ(near.distance.pixel(x, y)[0], distance);
                EXPECT_EQ(near.gradient.pixel(x, y)[0], all.gradient.pixel(x, y)[0]);
                EXPECT_EQ(near.gradient.pixel(x, y)[1], all.gradient.pixel(x, y)[1]);
            } else {
                EXPECT_EQ(near.distance.pixel(x, y)[0], std::numeric_limits<float>::infinity());
                EXPECT_EQ(near.gradient.pixel(x, y)[0], 0.0F);
                EXPECT_EQ(near.gradient.pixel(x, y)[1], 0.0F);
            }
        }
    }
}

TEST(ArcDistance, GradientPointsAwayFromTheNearestPoint) {
    const Vec2 tail(17.0, 19.0);
    for (const double half_angle : {-2.9, -0.7, -0.01, 0.02, 0.9, 1.5, 3.0}) {
        const FilmArc arc{{12.0, 5.0}, half_angle};
        const ArcDistances image = distances_to_arc(pixel_arc(arc), tail, 100.0);
        for (int y = 2; y < image.distance.height(); y += 11) {
            for (int x = 2; x < image.distance.width(); x += 11) {
                const Vec2 point = Vec2(x + 0.5, y + 0.5) - tail;
                const double distance = exact_distance(arc, point);
                const Vec2 gradient(image.gradient.pixel(x, y)[0], image.gradient.pixel(x, y)[1]);
                EXPECT_NEAR(gradient.norm(), 1.0, 1e-6);
                // Only the right gradient leads to the arc.
                EXPECT_LT(exact_distance(arc, point - distance * gradient), 2e-3)
                    << "half angle " << half_angle << ", point " << point.transpose();
            }
        }
    }
}

// Arcs of all shapes at random positions: wide ones, tiny ones and one without length. Chords are
// in pixels, half angles in radians.
struct RandomArcs {
    RandomArcs(int count, const Vec2& low, const Vec2& size) {
        Random random(7);
        const auto between = [&](double least, double most) {
            return least + (most - least) * random.uniform();
        };
        for (int k = 0; k < count; ++k) {
            const double length = k == 0 ? 0.0 : std::exp(between(std::log(1e-4), std::log(30.0)));
            const double direction = between(0.0, 2.0 * std::numbers::pi);
            const double half_angle = k % 3 == 0 ? between(-2.5, 2.5) : between(-0.8, 0.8);
            shapes.push_back({length * Vec2(std::cos(direction), std::sin(direction)), half_angle});
            const double x = low.x() + size.x() * random.uniform();
            const double y = low.y() + size.y() * random.uniform();
            placed.push_back({{x, y}, pixel_arc(shapes.back())});
        }
    }

    std::vector<FilmArc> shapes;
    std::vector<PlacedArc> placed;
};

// Returns the distance from a point, in foam units, to the nearest of all arcs and of their copies.
double nearest_distance(const RandomArcs& arcs,
                        const Domain& domain,
                        double scale,
                        const Vec2& point) {
    // An arc extends up to 60 pixels from its tail.
    const double period = scale * std::min(domain.width, domain.height);
    const int copies = domain.is_plane() ? 0 : 1 + static_cast<int>(70.0 / period);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < arcs.shapes.size(); ++k) {
        for (int j = -copies; j <= copies; ++j) {
            for (int i = -copies; i <= copies; ++i) {
                const Vec2 tail = arcs.placed[k].tail + domain.translation({i, j});
                nearest = std::min(nearest, exact_distance(arcs.shapes[k], scale * (point - tail)));
            }
        }
    }
    return nearest;
}

// Tails are rounded to subpixels, so distances may also be wrong by half of the diagonal of a
// subpixel, which is less than kMargin.
void expect_nearest(const RandomArcs& arcs,
                    const RasterGrid& grid,
                    const Domain& domain,
                    double reach) {
    const double scale = pixels_per_unit(grid, domain);
    const Image<float> image =
        distances_to_arcs(arcs.placed, grid, domain, {reach, false}, 2).distance;
    const Vec2 corner = grid.view
                            ? Vec2(grid.view->center - 0.5 / scale * Vec2(grid.width, grid.height))
                            : Vec2(Vec2(grid.shift_x, grid.shift_y) / scale);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const Vec2 point = corner + Vec2(x + 0.5, y + 0.5) / scale;
            const double expected = nearest_distance(arcs, domain, scale, point);
            const auto distance = static_cast<double>(image.pixel(x, y)[0]);
            if (expected < reach - PixelBatch::kMargin) {
                EXPECT_NEAR(distance, expected, PixelBatch::kMargin) << x << ", " << y;
            } else if (expected > reach + PixelBatch::kMargin) {
                EXPECT_EQ(distance, std::numeric_limits<double>::infinity()) << x << ", " << y;
            }
        }
    }
}

TEST(ArcDistance, IsTheDistanceToTheNearestOfManyArcs) {
    for (const double reach : {1.5, 9.3, 200.0}) {
        for (const RasterGrid& grid :
             {RasterGrid{61, 53}, {61, 53, 20, 37}, {7, 7}, {32, 16, -5, 3}}) {
            const Domain domain{grid.width / 10.0, grid.height / 10.0};
            const RandomArcs arcs(12, {0.0, 0.0}, {domain.width, domain.height});
            expect_nearest(arcs, grid, domain, reach);
        }
        const Domain sheared{6.1, 5.3, 1.234};
        const RandomArcs arcs(12, {0.0, 0.0}, {sheared.width, sheared.height});
        expect_nearest(arcs, {61, 53, 20, 37}, sheared, reach);
        const RandomArcs in_patch(12, {-4.0, -4.0}, {8.0, 8.0});
        expect_nearest(in_patch, {61, 53, 0, 0, View{{0.3, -0.2}, 10.0}}, kPlane, reach);
    }
}

// An arc through the corner of a torus is also near the other three corners of the image.
TEST(ArcDistance, ContinuesAcrossTheBordersOfATorus) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.0, 0.0}, {{2.0, 0.0}, 1.0, 0.0}}};
    const Image<float> image = distances_to_arcs(arcs, {32, 32}, domain, {4.0}, 1).distance;
    EXPECT_FLOAT_EQ(image.pixel(1, 0)[0], 0.5F);
    EXPECT_FLOAT_EQ(image.pixel(1, 31)[0], 0.5F);
    EXPECT_FLOAT_EQ(image.pixel(31, 0)[0], std::sqrt(0.5F));
    EXPECT_FLOAT_EQ(image.pixel(31, 31)[0], std::sqrt(0.5F));
    EXPECT_EQ(image.pixel(16, 16)[0], std::numeric_limits<float>::infinity());
}

// A line that crosses the image from end to end, 3 million pixels to each side, in a magnified view
// of a patch.
TEST(ArcDistance, MayBeginFarFromTheImage) {
    const std::vector<PlacedArc> arcs = {{{-3e6, 0.0}, {{6e6, 0.0}, 1.0, 0.0}}};
    const RasterGrid grid{8, 8, 0, 0, View{Vec2::Zero(), 1.0}};
    const Image<float> image = distances_to_arcs(arcs, grid, kPlane, {2.0}, 1).distance;
    EXPECT_EQ(image.pixel(0, 4)[0], 0.5F);
    EXPECT_EQ(image.pixel(7, 2)[0], 1.5F);
    EXPECT_EQ(image.pixel(0, 0)[0], std::numeric_limits<float>::infinity());
}

TEST(ArcDistance, DoesNotDependOnTheNumberOfThreads) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.1, 0.2}, {{70.0, 20.0}, 0.8, 0.6}},
                                         {{0.9, 0.6}, {{40.0, 90.0}, 0.6, -0.8}}};
    const ArcDistances one = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 1);
    const ArcDistances four = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 4);
    EXPECT_EQ(one.distance, four.distance);
    EXPECT_EQ(one.gradient, four.gradient);
}

TEST(ArcDistance, AShiftOfTheGridIsCyclicToTheBit) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = RandomArcs(300, {0.0, 0.0}, {1.0, 1.0}).placed;
    const ArcDistances still = distances_to_arcs(arcs, {150, 150}, domain, {30.0, true}, 1);
    const ArcDistances shifted =
        distances_to_arcs(arcs, {150, 150, 37, -61}, domain, {30.0, true}, 1);
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 150; ++x) {
            const int from_x = (x + 37) % 150;
            const int from_y = (y - 61 + 150) % 150;
            EXPECT_EQ(shifted.distance.pixel(x, y)[0], still.distance.pixel(from_x, from_y)[0]);
            EXPECT_EQ(shifted.gradient.pixel(x, y)[0], still.gradient.pixel(from_x, from_y)[0]);
            EXPECT_EQ(shifted.gradient.pixel(x, y)[1], still.gradient.pixel(from_x, from_y)[1]);
        }
    }
}

TEST(ArcDistance, TheGradientIsOptional) {
    const Domain domain{1.0, 1.0};
    const std::vector<PlacedArc> arcs = {{{0.1, 0.2}, {{70.0, 20.0}, 0.8, 0.6}}};
    const ArcDistances with = distances_to_arcs(arcs, {160, 120}, domain, {30.0, true}, 1);
    const ArcDistances without = distances_to_arcs(arcs, {160, 120}, domain, {30.0, false}, 1);
    EXPECT_EQ(with.distance, without.distance);
    EXPECT_EQ(with.gradient.width(), 160);
    EXPECT_TRUE(without.gradient.samples().empty());
}

// The sum of the coverage is the area of a stroke with round ends.
TEST(ArcDistance, StrokesHaveTheirArea) {
    const Domain domain{1.0, 1.0};
    for (const double width : {0.25, 1.0, 3.0, 9.5}) {
        const PixelArc line{{30.0, 17.0}, 1.0, 0.0};
        const std::vector<PlacedArc> arcs = {{{0.8, 0.7}, line}};
        const Image<float> image = stroke_coverage(
            distances_to_arcs(arcs, {96, 96}, domain, stroke_needs(width), 1).distance, width);
        double sum = 0.0;
        for (const float sample : image.samples()) {
            sum += static_cast<double>(sample);
        }
        const double wide = std::max(width, 1.0);
        const double area = std::min(width, 1.0) *
                            (wide * line.chord.norm() + 0.25 * std::numbers::pi * wide * wide);
        EXPECT_NEAR(sum, area, 0.01 * area + 0.2 * std::min(width, 1.0)) << width;
    }
}

}  // namespace
}  // namespace foam::texgen
