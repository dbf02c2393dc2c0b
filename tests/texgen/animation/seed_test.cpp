// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/seed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

Preset preset_of(FoamKind kind) {
    Preset preset;
    preset.shape.kind = kind;
    preset.seeding.bubbles = 60;
    preset.image.width = 96;
    preset.image.height = 48;
    return preset;
}

TEST(Seed, ATorusHasTheAspectOfTheImageAndAreaOneABubble) {
    const Domain domain = seeded_foam(preset_of(FoamKind::Torus)).domain;
    EXPECT_NEAR(domain.width / domain.height, 2.0, 1e-12);
    EXPECT_NEAR(domain.area(), 60.0, 1e-12);
}

// An ellipse of area 60 and aspect ratio 4 is 17.5 wide and 4.4 high. The size of the image has no
// influence.
TEST(Seed, APatchHasTheShapeOfItsOutlineAndAreaOneABubble) {
    Preset preset = preset_of(FoamKind::Patch);
    preset.shape.outline_aspect = 4.0;
    const Foam foam = seeded_foam(preset);
    EXPECT_TRUE(foam.domain.is_plane());
    const auto count = static_cast<double>(foam.network.bubble_count());
    EXPECT_NEAR(count, 60.0, 6.0);
    double area = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        area += foam.target_areas[bubble];
    }
    EXPECT_NEAR(area / count, 1.0, 1e-9);
    Vec2 reach = Vec2::Zero();
    for (const Vec2& position : foam.positions) {
        reach = reach.cwiseMax(position.cwiseAbs());
    }
    EXPECT_NEAR(reach.x(), 8.7, 1.0);
    EXPECT_NEAR(reach.y(), 2.2, 0.6);
}

// The outline is so narrow that some of ten thousand sites are at the same point of the grid of the
// Voronoi diagram.
TEST(Seed, AnOutlineThatHoldsNoFoamIsABadRequest) {
    Preset preset = preset_of(FoamKind::Patch);
    preset.seeding.bubbles = 10000;
    preset.shape.outline = "POLYGON((0 0, 1 0, 1 0.000000002, 0 0.000000002))";
    try {
        seeded_foam(preset);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).find("foam.outline: cannot seed 10000 bubbles"), 0U);
    }
}

// One site on a torus and its copies make rectangles, whose corners join four cells.
TEST(Seed, ATorusThatHoldsNoFoamIsABadRequest) {
    Preset preset = preset_of(FoamKind::Torus);
    preset.seeding.bubbles = 1;
    try {
        seeded_foam(preset);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).find("foam.bubbles: cannot seed 1 bubbles"), 0U);
    }
}

// The density `gradient` is dark in the middle of the height of a torus, and at the bottom of a
// patch. Areas differ by the ratio of the density.
TEST(Seed, ADensityMakesBubblesSmallWhereItIsDark) {
    Preset preset = preset_of(FoamKind::Torus);
    preset.seeding.bubbles = 400;
    preset.density.source.name = "gradient";
    preset.density.ratio = 16.0;
    const Foam foam = seeded_foam(preset);
    const auto [smallest, largest] =
        std::minmax_element(foam.target_areas.begin(), foam.target_areas.end());
    EXPECT_GT(*largest / *smallest, 8.0);
    EXPECT_LT(*largest / *smallest, 16.1);
    for (const BubbleId bubble : foam.network.bubbles()) {
        const JunctionId corner = foam.network.tail(foam.network.first(bubble));
        const double height = foam.positions[corner].y() / foam.domain.height;
        if (std::abs(height - 0.5) < 0.1) {
            EXPECT_LT(foam.target_areas[bubble], 1.0);
        }
    }
    preset.shape.kind = FoamKind::Patch;
    preset.shape.outline = "rectangle";
    const Foam patch = seeded_foam(preset);
    double low = 0.0;
    double high = 0.0;
    for (const JunctionId junction : patch.network.junctions()) {
        const double y = patch.positions[junction].y();
        low += y < 0.0 ? 1.0 : 0.0;
        high += y < 0.0 ? 0.0 : 1.0;
    }
    EXPECT_GT(high, 0.0);
    // The mean of the junctions is at y = 0; below it, where bubbles are small, there is less
    // space.
    EXPECT_GT(low, high);
}

}  // namespace
}  // namespace foam::texgen
