// SPDX-License-Identifier: Apache-2.0

#include "core/foam/measure.h"
#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"
#include "texgen/raster/coverage/fill.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {
namespace {

using Image16 = Image<std::uint16_t>;

constexpr double kPi = std::numbers::pi;
constexpr const char* kFrame = "POLYGON((0 0, 9 0, 9 9, 0 9), (2 2, 2 7, 7 7, 7 2))";

RasterGrid grid_of(int width, int height, const Vec2& center, double scale) {
    return {width, height, 0, 0, View{center, scale}};
}
std::size_t value_count(const Frame& frame) {
    return frame.network.bubble_slots() + frame.lone_bubbles.size();
}

// Returns values with which bubbles and films are white and the surroundings are black.
CellValues opacity(const Frame& frame) {
    CellValues values{1, std::vector<std::uint16_t>(value_count(frame), 65535), {65535}};
    values.bubbles[index_of(frame.network.ghost())] = 0;
    return values;
}

Image16 filled(const Frame& frame, const RasterGrid& grid, double width, const CellValues& values) {
    const CellArcs cells = cell_arcs(frame, grid, width, 1);
    EXPECT_EQ(cells.unclosed_loops, 0);
    Image16 image(grid.width, grid.height, static_cast<int>(values.channels));
    fill_cells(cells, values, 1, image.view());
    return image;
}

// Returns the sum of all pixels, where white is 1.
double white_area(const Image16& image) {
    double area = 0.0;
    for (const std::uint16_t sample : image.samples()) {
        area += sample / 65535.0;
    }
    return area;
}

double opaque_area(const Frame& frame, const RasterGrid& grid, double width) {
    return white_area(filled(frame, grid, width, opacity(frame)));
}

// A circle of radius r with a film of width w covers the area pi (r + w / 2)². The film covers 2 pi
// r w of it.
TEST(PatchArcs, OfACircleHaveItsArea) {
    const Frame frame = snapshot(test::circles({{0, {0.3, -0.2}, 2.0}}), 1);
    const double radius = std::sqrt(2.0 / kPi);
    for (const double scale : {8.0, 20.0, 55.0}) {
        const RasterGrid grid = grid_of(128, 128, Vec2::Zero(), scale);
        for (const double width : {0.0, 0.5, 3.0, 7.0}) {
            const double outer = scale * radius + 0.5 * width;
            EXPECT_NEAR(opaque_area(frame, grid, width) / (kPi * outer * outer), 1.0, 1e-4)
                << scale << " " << width;
        }
    }
    CellValues film = opacity(frame);
    film.bubbles[1] = 0;
    const Image16 ring = filled(frame, grid_of(128, 128, Vec2::Zero(), 50.0), 4.0, film);
    EXPECT_NEAR(white_area(ring) / (2.0 * kPi * 50.0 * radius * 4.0), 1.0, 1e-4);
}

// The films of two circles just overlap. The covered area is two discs minus one lens, which
// consists of two segments.
TEST(PatchArcs, OfCirclesThatAreCloseMerge) {
    const double r = std::sqrt(1.0 / kPi);
    const Frame frame =
        snapshot(test::circles({{0, {-r - 0.01, 0.0}, 1.0}, {1, {r + 0.01, 0.0}, 1.0}}), 1);
    const double scale = 50.0;
    const double outer = scale * r + 2.5;
    const double half_gap = scale * (r + 0.01);
    const double angle = std::acos(half_gap / outer);
    const double segment = outer * outer * (angle - std::sin(angle) * std::cos(angle));
    const double expected = 2.0 * kPi * outer * outer - 2.0 * segment;
    EXPECT_GT(segment, 1.0);
    EXPECT_NEAR(
        opaque_area(frame, grid_of(160, 96, Vec2::Zero(), scale), 5.0) / expected, 1.0, 1e-4);
}

// Without films, the sum of the opacities is the area of the patch. If the surroundings have the
// value of the bubbles, every pixel has this value.
TEST(PatchArcs, WithoutWidthEndAtTheOuterArcs) {
    for (const Foam& foam : {test::patch_foam(2, 3), test::patch_foam(40, 1, kFrame)}) {
        const Frame frame = snapshot(foam, 1);
        double area = 0.0;
        for (const FrameBubble& bubble : frame.bubbles) {
            area += bubble.area;
        }
        const double scale = 12.0;
        const RasterGrid grid = grid_of(160, 160, Vec2::Zero(), scale);
        EXPECT_NEAR(opaque_area(frame, grid, 0.0) / (area * scale * scale), 1.0, 1e-4);
        CellValues outside{1, std::vector<std::uint16_t>(value_count(frame), 54321), {7}};
        outside.bubbles[index_of(frame.network.ghost())] = 54321;
        const Image16 image = filled(frame, grid, 0.0, outside);
        for (const std::uint16_t sample : image.samples()) {
            ASSERT_EQ(sample, 54321);
        }
    }
}

// Draws each bubble, and the surroundings, in white. Returns the largest difference of a pixel from
// the samples.
double largest_error(const Frame& frame, const RasterGrid& grid, double width) {
    const test::SampledCoverage sampled =
        test::sample_coverage(frame, *grid.view, grid.width, grid.height, width);
    double largest = 0.0;
    for (std::size_t k = 0; k < value_count(frame); ++k) {
        CellValues values{1, std::vector<std::uint16_t>(value_count(frame), 0), {}};
        values.bubbles[k] = 65535;
        const Image16 image = filled(frame, grid, width, values);
        for (std::size_t pixel = 0; pixel < sampled.parts.size(); ++pixel) {
            const double exact = image.samples()[pixel] / 65535.0;
            largest = std::max(largest, std::abs(exact - sampled.parts[pixel][k]));
        }
    }
    return largest;
}

// The tolerance is explained at FillAgainstSamples (fill_test.cpp).
constexpr double kReferenceTolerance = 0.0027;

TEST(PatchArcsAgainstSamples, AgreeForAPatchOfManyBubbles) {
    const Frame frame = snapshot(test::patch_foam(12, 5), 1);
    const RasterGrid grid = grid_of(30, 28, {0.1, 0.2}, 6.0);
    EXPECT_LT(largest_error(frame, grid, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, grid, 1.3), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, grid, 6.0), kReferenceTolerance);
}

TEST(PatchArcsAgainstSamples, AgreeForAHoleAndRaftsThatAreClose) {
    Foam foam = test::ring_foam();
    // One lone bubble is in the hole. The other one is 0.12, less than a pixel, from an outer film,
    // whose middle is 1.905 + 1.1 tan(0.35) from the origin.
    foam.lone_bubbles = {{90, {0.05, -0.02}, 0.1}, {91, {2.45, 1.415}, 0.5}};
    const Frame frame = snapshot(foam, 1);
    const RasterGrid grid = grid_of(36, 36, {0.4, 0.3}, 6.0);
    EXPECT_LT(largest_error(frame, grid, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, grid, 1.1), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, grid, 3.0), kReferenceTolerance);
}

TEST(PatchArcsAgainstSamples, AgreeForOuterFilmsThatBulgeBeyondHalfACircle) {
    const Frame frame = snapshot(test::patch_foam(2, 1), 1);
    const RasterGrid grid = grid_of(26, 26, {0.0, 0.0}, 9.0);
    EXPECT_LT(largest_error(frame, grid, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, grid, 2.0), kReferenceTolerance);
}

// Two circles of radius 1 and 0.5, whose centers are 1.2 apart, overlap. With films of 0.2 they
// cover two discs of radius 1.1 and 0.6. The union of the discs follows from their common chord,
// which is at x = (1.1² - 0.6² + 1.2²) / 2.4 from the first center.
TEST(PatchArcs, RaftsThatOverlapBothShow) {
    const Frame frame =
        snapshot(test::circles({{0, {0.0, 0.0}, kPi}, {1, {1.2, 0.0}, 0.25 * kPi}}), 1);
    const double x = (1.1 * 1.1 - 0.6 * 0.6 + 1.2 * 1.2) / 2.4;
    const auto cap = [](double radius, double distance) {
        return radius * radius * std::acos(distance / radius) -
               distance * std::sqrt(radius * radius - distance * distance);
    };
    const double expected = kPi * (1.1 * 1.1 + 0.6 * 0.6) - cap(1.1, x) - cap(0.6, 1.2 - x);
    const double scale = 40.0;
    const RasterGrid grid = grid_of(160, 120, {0.4, 0.0}, scale);
    EXPECT_NEAR(opaque_area(frame, grid, 8.0) / (expected * scale * scale), 1.0, 1e-3);
}

// A view that is displaced by whole pixels shows the same pixels: nothing wraps around, and what is
// outside of the view has no influence. The displacements are multiples of a quarter of a unit,
// which is exactly four pixels.
TEST(PatchArcs, APartOfAPictureIsThatPartBitForBit) {
    const Frame frame = snapshot(test::patch_foam(30, 4, kFrame), 1);
    const Image16 whole = filled(frame, grid_of(128, 128, Vec2::Zero(), 16.0), 2.0, opacity(frame));
    for (const Vec2& move : {Vec2(2.75, -1.5), Vec2(-3.0, 0.25), Vec2(0.0, 2.5)}) {
        const Image16 part = filled(frame, grid_of(32, 32, move, 16.0), 2.0, opacity(frame));
        const auto left = static_cast<int>(48 + 16.0 * move.x());
        const auto low = static_cast<int>(48 + 16.0 * move.y());
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                ASSERT_EQ(part.pixel(x, y)[0], whole.pixel(left + x, low + y)[0]) << x << " " << y;
            }
        }
    }
}

// The bubble is a million pixels wide. Its film is cut off far outside of the view, and is still
// drawn exactly.
TEST(PatchArcs, AVeryCloseViewIsCutOffExactly) {
    const Frame frame = snapshot(test::circles({{0, {0.0, 0.0}, kPi}}), 1);
    const double scale = 5e5;
    const double width = 12.0;
    for (const double angle : {0.0, 0.4, 1.2, 2.0, 4.0}) {
        const Vec2 on_film(std::cos(angle), std::sin(angle));
        const RasterGrid grid = grid_of(64, 64, on_film, scale);
        const double sagitta = 32.0 * 32.0 / (2.0 * scale);
        CellValues values = opacity(frame);
        values.bubbles[1] = 0;  // the film alone
        const Image16 image = filled(frame, grid, width, values);
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                const Vec2 at(x - 31.5, y - 31.5);
                const double distance = std::abs(at.dot(on_film));
                const double slack = 0.75 + sagitta;
                const bool is_film = distance < 0.5 * width - slack;
                const bool is_free = distance > 0.5 * width + slack;
                ASSERT_TRUE(!is_film || image.pixel(x, y)[0] == 65535);
                ASSERT_TRUE(!is_free || image.pixel(x, y)[0] == 0);
            }
        }
        // These views show only the bubble, or only its surroundings.
        const RasterGrid inside = grid_of(8, 8, 0.9 * on_film, scale);
        EXPECT_EQ(opaque_area(frame, inside, width), 64.0);
        EXPECT_EQ(opaque_area(frame, grid_of(8, 8, 1.1 * on_film, scale), width), 0.0);
    }
}

TEST(PatchArcs, DoNotDependOnThreads) {
    const Frame frame = snapshot(test::patch_foam(600, 1), 1);
    const RasterGrid grid = grid_of(256, 256, Vec2::Zero(), 8.0);
    for (const double width : {0.0, 2.0}) {
        const CellArcs one = cell_arcs(frame, grid, width, 1);
        const CellArcs three = cell_arcs(frame, grid, width, 3);
        EXPECT_GT(one.batches.size(), 1U);
        Image16 a(256, 256, 1);
        Image16 b(256, 256, 1);
        fill_cells(one, opacity(frame), 1, a.view());
        fill_cells(one, opacity(frame), 3, b.view());
        EXPECT_EQ(a, b);
    }
}

TEST(PatchArcs, AreEmptyWithoutBubbles) {
    const Frame frame = snapshot(test::circles({}), 1);
    EXPECT_EQ(opaque_area(frame, grid_of(16, 16, Vec2::Zero(), 4.0), 3.0), 0.0);
}

TEST(PatchArcs, NeedAView) {
    const Frame frame = snapshot(test::circles({{0, {0.0, 0.0}, 1.0}}), 1);
    EXPECT_THROW(cell_arcs(frame, {16, 16, 0, 0}, 1.0, 1), std::invalid_argument);
}

// Straight colors are the colors of the cells, however small the part of a pixel that they cover.
TEST(FillStraight, ColorsAreWholeWhereOpacityIsNot) {
    const Frame frame = snapshot(test::circles({{0, {0.0, 0.0}, 2.0}}), 1);
    CellValues values{4, {0, 0, 0, 0, 1000, 65535, 30001, 65535}, {1000, 65535, 30001, 65535}};
    const CellArcs cells = cell_arcs(frame, grid_of(40, 40, Vec2::Zero(), 20.0), 3.0, 1);
    Image16 image(40, 40, 4);
    fill_straight(cells, values, 1, image.view());
    const Image16 opaque = filled(frame, cells.grid, 3.0, opacity(frame));
    int partly = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            const auto pixel = image.pixel(x, y);
            EXPECT_EQ(pixel[3], opaque.pixel(x, y)[0]);
            partly += pixel[3] > 0 && pixel[3] < 65535 ? 1 : 0;
            if (pixel[3] > 0) {
                EXPECT_EQ(pixel[0], 1000);
                EXPECT_EQ(pixel[1], 65535);
                EXPECT_EQ(pixel[2], 30001);
            }
        }
    }
    EXPECT_GT(partly, 60);
}

}  // namespace
}  // namespace foam::texgen
