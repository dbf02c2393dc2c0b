// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/fill.h"

#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"
#include "core/foam/locate.h"
#include "core/foam/random.h"
#include "core/network/validate.h"
#include "tests/support/raster_reference.h"
#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foam::texgen {
namespace {

using Image16 = Image<std::uint16_t>;

CellValues random_values(std::size_t bubbles, std::size_t channels, std::uint64_t seed) {
    Random random(seed);
    CellValues values{channels, {}, {65535, 0, 30000, 1}};
    for (std::size_t k = 0; k < bubbles * channels; ++k) {
        values.bubbles.push_back(static_cast<std::uint16_t>(random.below(65536)));
    }
    return values;
}

Image16 filled(const CellArcs& cells, const CellValues& values, int threads = 1) {
    Image16 image(cells.grid.width, cells.grid.height, static_cast<int>(values.channels));
    fill_cells(cells, values, threads, image.view());
    return image;
}

Image16 filled(const Frame& frame, const RasterGrid& grid, double width, const CellValues& values) {
    return filled(cell_arcs(frame, grid, width, 1), values);
}

// Returns foams for the tests of exact properties, including a foam of a single bubble.
std::vector<Foam> foams() {
    std::vector<Foam> all;
    all.push_back(test::single_bubble());
    all.push_back(honeycomb(1, 2));
    all.push_back(honeycomb(2, 2));
    all.push_back(test::bent_foam(4, 0.3, 2));
    all.push_back(test::bent_foam(60, 0.5, 3));
    Foam lens = honeycomb(2, 2);
    test::insert_lens(lens, id_at<FilmId>(0), 0.4);
    test::insert_lens(lens, id_at<FilmId>(5), 0.2);
    all.push_back(lens);
    return all;
}

TEST(Fill, TestFoamsAreValid) {
    for (const Foam& foam : foams()) {
        EXPECT_EQ(find_fault(foam.network).value_or(""), "");
    }
}

TEST(Fill, EqualCellsWithoutFilmsShowNoEdge) {
    for (const Foam& foam : foams()) {
        const Frame frame = test::fitted_frame(foam, 60, 37);
        const CellValues values{
            2, std::vector<std::uint16_t>(2 * frame.bubbles.size(), 54321), {7, 65535}};
        const Image16 image = filled(frame, {60, 37, 0, 0}, 0.0, values);
        for (const std::uint16_t sample : image.samples()) {
            ASSERT_EQ(sample, 54321) << frame.bubbles.size() << " bubbles";
        }
    }
}

// Every bubble has the full value in one of four channels. The channels of a pixel add up to the
// full value, up to the rounding of each channel.
TEST(Fill, CoverageSumsToOne) {
    for (const Foam& foam : foams()) {
        const Frame frame = test::fitted_frame(foam, 60, 37);
        CellValues values{4, std::vector<std::uint16_t>(4 * frame.bubbles.size(), 0), {}};
        for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
            values.bubbles[4 * k + k % 4] = 65535;
        }
        const Image16 image = filled(frame, {60, 37, 0, 0}, 0.0, values);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const auto pixel = image.pixel(x, y);
                EXPECT_NEAR(pixel[0] + pixel[1] + pixel[2] + pixel[3], 65535, 2);
            }
        }
    }
}

Image16 cyclically_shifted(const Image16& image, int i, int j) {
    Image16 shifted(image.width(), image.height(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto from = image.pixel(wrap(x + i, image.width()), wrap(y + j, image.height()));
            std::copy(from.begin(), from.end(), shifted.pixel(x, y).begin());
        }
    }
    return shifted;
}

TEST(Fill, AShiftOfTheGridIsACyclicShiftBitForBit) {
    Random random(11);
    for (const Foam& foam : foams()) {
        const Frame frame = test::fitted_frame(foam, 60, 37);
        const CellValues values = random_values(frame.bubbles.size(), 3, 5);
        for (const double width : {0.0, 2.5}) {
            const Image16 straight = filled(frame, {60, 37, 0, 0}, width, values);
            const int i = static_cast<int>(random.below(400)) - 200;
            const int j = static_cast<int>(random.below(400)) - 200;
            EXPECT_EQ(filled(frame, {60, 37, i, j}, width, values),
                      cyclically_shifted(straight, i, j))
                << i << "," << j;
        }
    }
}

bool is_all_cells(const Frame& frame, int size) {
    const CellValues white{1, std::vector<std::uint16_t>(frame.bubbles.size(), 65535), {}};
    const Image16 image = filled(frame, {size, size, 0, 0}, 0.0, white);
    return std::all_of(image.samples().begin(), image.samples().end(), [](std::uint16_t sample) {
        return sample == 65535;
    });
}

// A junction that is rounded to the far border of the torus stays connected to its films.
TEST(Fill, LeavesNoGapsAtTheBorder) {
    const Foam foam = test::bent_foam(30, 0.3, 3);
    for (const JunctionId junction : foam.network.junctions()) {
        Foam moved = foam;
        const Vec2 corner(moved.domain.width - 1e-9, moved.domain.height - 1e-9);
        const Vec2 by = corner - foam.positions[junction];
        for (const JunctionId each : foam.network.junctions()) {
            place_junction(moved, each, foam.positions[each] + by);
        }
        EXPECT_TRUE(is_all_cells(test::fitted_frame(moved, 40, 40), 40)) << index_of(junction);
    }
}

TEST(Fill, AShearedTorusIsCoveredOnce) {
    for (const double strain : {0.1, -0.37, 0.8}) {
        Foam foam = test::bent_foam(30, 0.3, 3);
        shear(foam, strain);
        EXPECT_TRUE(is_all_cells(test::fitted_frame(foam, 40, 40), 40)) << strain;
    }
}

// A pixel shows the bubble at its center, unless a film crosses it. This is also true for rows
// beyond the upper border, which are rows at the lower border, displaced to the right by the shear.
TEST(Fill, AShearedTorusShowsTheBubblesWhereTheyAre) {
    Foam foam = test::bent_foam(30, 0.3, 3);
    shear(foam, 0.3);
    const Frame frame = test::fitted_frame(foam, 80, 80);
    CellValues values{1, {}, {}};
    for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
        values.bubbles.push_back(static_cast<std::uint16_t>(1000 * (k + 1)));
    }
    for (const int shift_y : {0, 30}) {
        const Image16 image = filled(frame, {80, 80, 17, shift_y}, 0.0, values);
        int matching = 0;
        for (int y = 0; y < 80; ++y) {
            for (int x = 0; x < 80; ++x) {
                const Vec2 point = foam.domain.width / 80.0 * Vec2(x + 17.5, y + shift_y + 0.5);
                const std::uint16_t sample = image.row(y)[static_cast<std::size_t>(x)];
                matching += sample == values.bubbles[index_of(*bubble_at(foam, point))] ? 1 : 0;
            }
        }
        EXPECT_GT(matching, 80 * 80 * 7 / 10);
    }
}

TEST(Fill, DoesNotDependOnThreads) {
    const Frame frame = test::fitted_frame(test::bent_foam(300, 0.5, 3), 300, 300);
    const CellValues values = random_values(frame.bubbles.size(), 3, 6);
    for (const double width : {0.0, 1.5}) {
        const CellArcs cells = cell_arcs(frame, {300, 300, 0, 0}, width, 2);
        const Image16 one = filled(cells, values, 1);
        EXPECT_EQ(one, filled(cells, values, 2));
        EXPECT_EQ(one, filled(cells, values, 3));
        EXPECT_EQ(one, filled(cells, values, 0));  // all hardware threads
    }
}

TEST(Fill, HasTheSameBitsAtEverySimdLevel) {
    const Frame frame = test::fitted_frame(test::bent_foam(300, 0.5, 3), 300, 300);
    const CellValues values = random_values(frame.bubbles.size(), 3, 6);
    for (const double width : {0.0, 1.5}) {
        const auto fill = [&] {
            return filled(cell_arcs(frame, {300, 300, 0, 0}, width, 1), values, 1);
        };
        const Image16 image = fill();
        at_every_simd_level([&] { EXPECT_EQ(fill(), image); });
    }
}

// The pixels do not depend on the alignment of the image: its rows may or may not begin at a cache
// line.
TEST(Fill, LargeImagesAreTheSameWhereverTheyLie) {
    constexpr int kSide = 1120;  // a row is whole cache lines, but not whole words of flags
    const Frame frame = test::fitted_frame(test::bent_foam(60, 0.5, 3), kSide, kSide);
    const CellArcs cells = cell_arcs(frame, {kSide, kSide, 0, 0}, 3.0, 1);
    const CellValues values = random_values(frame.bubbles.size(), 4, 5);
    const Image16 image = filled(cells, values, 2);
    std::vector<std::uint16_t> moved(image.samples().size() + 1);
    fill_cells(cells, values, 1, {moved.data() + 1, kSide, kSide, 4});
    EXPECT_TRUE(std::ranges::equal(image.samples(), std::span(moved).subspan(1)));
}

TEST(Fill, RejectsMismatchedSizes) {
    const Frame frame = test::fitted_frame(honeycomb(2, 2), 8, 8);
    const CellArcs cells = cell_arcs(frame, {8, 8, 0, 0}, 0.0, 1);
    Image16 gray(8, 8, 1);
    Image16 wide(9, 8, 1);
    const CellValues good{1, {1, 2, 3, 4}, {}};
    EXPECT_NO_THROW(fill_cells(cells, good, 1, gray.view()));
    EXPECT_THROW(fill_cells(cells, good, 1, wide.view()), std::invalid_argument);
    EXPECT_THROW(fill_cells(cells, {1, {1, 2, 3}, {}}, 1, gray.view()), std::invalid_argument);
    EXPECT_THROW(fill_cells(cells, {2, std::vector<std::uint16_t>(8), {}}, 1, gray.view()),
                 std::invalid_argument);
}

// Draws one bubble after the other in white. Returns the largest difference of a pixel from the
// samples, where white is 1.
double largest_error(const Frame& frame, int size, double width) {
    const test::SampledCoverage sampled = test::sample_coverage(frame, size, size, width);
    const CellArcs cells = cell_arcs(frame, {size, size, 0, 0}, width, 1);
    EXPECT_EQ(cells.unclosed_loops, 0);
    double largest = 0.0;
    for (std::size_t bubble = 0; bubble < frame.bubbles.size(); ++bubble) {
        CellValues values{1, std::vector<std::uint16_t>(frame.bubbles.size(), 0), {}};
        values.bubbles[bubble] = 65535;
        const Image16 image = filled(cells, values);
        for (std::size_t k = 0; k < sampled.parts.size(); ++k) {
            const double exact = image.samples()[k] / 65535.0;
            largest = std::max(largest, std::abs(exact - sampled.parts[k][bubble]));
        }
    }
    return largest;
}

// The error of the arcs is below 0.001, rounding to subpixels adds up to 0.001, and the error of
// the samples is up to 0.0007. For comparison: half a step of 8 bits is 0.002.
constexpr double kReferenceTolerance = 0.0027;

TEST(FillAgainstSamples, AgreesForABentVoronoiDiagram) {
    const Frame frame = test::fitted_frame(test::bent_foam(14, 0.4, 21), 24, 24);
    EXPECT_LT(largest_error(frame, 24, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 1.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 3.7), kReferenceTolerance);
}

TEST(FillAgainstSamples, AgreesForAnEquilibriumWithTinyBubbles) {
    const Frame frame = test::fitted_frame(test::polydisperse_foam(24, 5), 24, 24);
    EXPECT_LT(largest_error(frame, 24, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 0.7), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 2.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 5.0), kReferenceTolerance);
}

TEST(FillAgainstSamples, AgreesForTwoSidedBubbles) {
    Foam foam = honeycomb(2, 2);
    test::insert_lens(foam, id_at<FilmId>(1), 0.6);
    test::insert_lens(foam, id_at<FilmId>(4), 0.25);
    const Frame frame = test::fitted_frame(foam, 24, 24);
    EXPECT_LT(largest_error(frame, 24, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 1.3), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 24, 3.0), kReferenceTolerance);
}

TEST(FillAgainstSamples, AgreesForABubbleThatMeetsItself) {
    const Frame frame = test::fitted_frame(test::single_bubble(), 20, 20);
    EXPECT_LT(largest_error(frame, 20, 0.0), kReferenceTolerance);
    EXPECT_LT(largest_error(frame, 20, 2.2), kReferenceTolerance);
    const Frame two = test::fitted_frame(honeycomb(1, 2), 20, 20);
    EXPECT_LT(largest_error(two, 20, 2.2), kReferenceTolerance);
}

}  // namespace
}  // namespace foam::texgen
