// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/contour.h"

#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "texgen/maps/albedo_options.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace foam::texgen {
namespace {

constexpr int kSide = 128;  // pixels

// A torus of 4 x 4 hexagons of area 1, whose pressures are 0 unless a test sets them.
struct Hexagons {
    Frame frame = foam::test::fitted_frame(honeycomb(4, 4), kSide, kSide);
    FoamRecord record;

    // Returns the area that lines cover, in foam units. The lines are black and 0.1 wide.
    double line_area(std::int64_t levels) {
        PressureOptions pressure;
        pressure.scaling = PressureScaling::Range;
        pressure.unit = PressureUnit::Seed;
        pressure.low = -0.5;
        pressure.high = 1.5;
        const RasterGrid grid{kSide, kSide};
        FrameLayers layers({frame, record}, grid, 1);
        const ContourOptions options{.levels = levels,
                                     .width = 0.1 / diameters_in_pixels(1.0, grid, frame.domain) *
                                              pixels_per_unit(grid, frame.domain),
                                     .line_color = "#000000",
                                     .ground_color = "#ffffff"};
        const ColorPixels image = draw_contour(layers, options, pressure);
        double dark = 0.0;
        for (std::size_t k = 0; k < image.pixels.samples().size(); k += 3) {
            dark += 1.0 - image.pixels.samples()[k] / kWhite;
        }
        return dark / std::pow(pixels_per_unit(grid, frame.domain), 2);
    }
    void set_pressure(std::size_t bubble, double pressure) {
        frame.bubbles[id_at<BubbleId>(bubble)].pressure = frame.film_tension * pressure;
    }
    double perimeter(std::size_t bubble) const {
        const auto id = id_at<BubbleId>(bubble);
        double length = 0.0;
        for (const HalfEdgeId side : frame.network.around(id)) {
            length += frame.arc(side).chord.norm();
        }
        return length;
    }
};

TEST(Contour, BubblesOfOneLevelHaveNoLine) {
    Hexagons hexagons;
    hexagons.set_pressure(5, 0.4);  // tone 0.45, below the middle as the others' 0.25
    EXPECT_EQ(hexagons.line_area(2), 0.0);
}

// A hexagon of another level has six lines. Where two of them meet, they are rounded.
TEST(Contour, ABubbleOfAnotherLevelIsOutlined) {
    Hexagons hexagons;
    hexagons.set_pressure(5, 1.0);
    const double area = hexagons.perimeter(5) * 0.1;
    EXPECT_NEAR(hexagons.line_area(2), area, 0.02 * area);
}

TEST(Contour, MoreLevelsHaveMoreLines) {
    Hexagons hexagons;
    hexagons.set_pressure(5, 0.1);  // tones 0.3 and 0.25 are on one of 3 levels, but two of 7
    EXPECT_EQ(hexagons.line_area(3), 0.0);
    EXPECT_GT(hexagons.line_area(7), 0.0);
}

TEST(Contour, LimitsHoldOnBothSides) {
    test::expect_limits(contour_keys(),
                        {{"levels", "1", "2", "256", "257"}, {"width", "-0.1", "0", "10", "10.1"}});
}

}  // namespace
}  // namespace foam::texgen
