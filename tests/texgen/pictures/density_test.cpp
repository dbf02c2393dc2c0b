// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

DensityOptions built_in(const std::string& name) {
    DensityOptions options;
    options.source.name = name;
    options.ratio = 100.0;
    return options;
}

// A picture of two opaque gray pixels, the left one black and the right one white.
DensityOptions black_and_white() {
    auto picture = std::make_shared<SourcePicture>(SourcePicture{{2, 1, 4}});
    const std::vector<std::uint16_t> samples{0, 0, 0, 65535, 65535, 65535, 65535, 65535};
    std::ranges::copy(samples, picture->pixels.samples().begin());
    DensityOptions options;
    options.source = {"bw.png", {"bw.png", picture, "hash"}};
    options.ratio = 100.0;
    return options;
}

TEST(Density, AnEvenDensityHasNoField) {
    EXPECT_FALSE(area_field_of({}, {}).has_value());
}

TEST(Density, BubblesAreSmallWhereAPictureIsDark) {
    const AreaField field = *area_field_of(black_and_white(), {true, 2.0});
    EXPECT_NEAR(field.at({0.75, 0.5}) / field.at({0.25, 0.5}), 100.0, 1e-9);
    DensityOptions inverted = black_and_white();
    inverted.is_inverted = true;
    const AreaField other = *area_field_of(inverted, {true, 2.0});
    EXPECT_NEAR(other.at({0.25, 0.5}) / other.at({0.75, 0.5}), 100.0, 1e-9);
}

// 1 / sqrt(a) is linear in the darkness: it is 1 in the middle, 0.1 at the edge, and 0.55 at a
// quarter of the height, where the darkness is one half.
TEST(Density, AGradientOnATorusIsDarkInTheMiddleAndPeriodic) {
    const AreaField field = *area_field_of(built_in("gradient"), {true, 1.0});
    EXPECT_NEAR(field.at({0.3, 0.5}), 1.0, 1e-3);
    EXPECT_NEAR(field.at({0.3, 0.0}), 100.0, 0.1);
    EXPECT_NEAR(field.at({0.3, 0.25}), 1.0 / (0.55 * 0.55), 0.05);
    EXPECT_EQ(field.at({0.1, 0.25}), field.at({0.9, 0.25}));
}

TEST(Density, AGradientOfAPatchIsDarkAtTheBottom) {
    const AreaField field = *area_field_of(built_in("gradient"), {false, 1.0});
    EXPECT_NEAR(field.at({0.5, 0.001}), 1.0, 1e-9);
    EXPECT_NEAR(field.at({0.5, 0.999}), 100.0, 1e-9);
}

// The center of the first cell is 1/1024 of the width from the edge.
TEST(Density, ARadialDensityIsDarkInTheMiddle) {
    for (const bool is_torus : {true, false}) {
        const AreaField field = *area_field_of(built_in("radial"), {is_torus, 1.5});
        EXPECT_NEAR(field.at({0.5, 0.5}), 1.0, 0.01);
        EXPECT_NEAR(field.at({0.0, 0.5}), 100.0, 4.0);
    }
}

TEST(Density, NoiseDependsOnItsSeedAndIsPeriodic) {
    DensityOptions options = built_in("noise");
    const AreaField one = *area_field_of(options, {true, 1.0});
    EXPECT_EQ(one.at({0.3, 0.6}), area_field_of(options, {true, 1.0})->at({0.3, 0.6}));
    options.noise_seed = 2;
    EXPECT_NE(one.at({0.3, 0.6}), area_field_of(options, {true, 1.0})->at({0.3, 0.6}));
    // Adjacent cells of the grid differ little, also across the edge.
    for (const double y : {0.1, 0.4, 0.8}) {
        EXPECT_NEAR(one.at({0.9995, y}) / one.at({0.0005, y}), 1.0, 0.1);
    }
}

TEST(Density, RemarksOnPicturesThatAreStretchedOrDoNotTile) {
    const DensityOptions options = black_and_white();
    const std::vector<std::string> both = density_remarks(options, {true, 1.0});
    ASSERT_EQ(both.size(), 1U);  // two pixels have no step that is larger than their difference
    EXPECT_EQ(
        both.front(),
        "foam.density: 'bw.png' of 2 x 1 pixels is stretched to the aspect ratio of the foam, "
        "1");
    EXPECT_TRUE(density_remarks(options, {true, 2.0}).empty());
    EXPECT_TRUE(density_remarks({}, {true, 1.0}).empty());
}

}  // namespace
}  // namespace foam::texgen
