// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/picture_color.h"

#include "core/foam/honeycomb.h"
#include "core/foam/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

namespace foam::texgen {
namespace {

// A picture of `columns` gray columns, from black at the left to white at the right.
AlbedoOptions steps(int columns) {
    auto picture = std::make_shared<SourcePicture>(SourcePicture{{columns, 1, 4}});
    for (int x = 0; x < columns; ++x) {
        const auto light = static_cast<std::uint16_t>(65535 * x / (columns - 1));
        const auto pixel = picture->pixels.pixel(x, 0);
        pixel[0] = pixel[1] = pixel[2] = light;
        pixel[3] = 65535;
    }
    AlbedoOptions options;
    options.color_by = ColorBy::Picture;
    options.picture = {"steps.png", picture, "hash"};
    return options;
}

Frame hexagons() {
    return snapshot(foam::honeycomb(4, 4), 1);
}

FrameOne first_frame(const Frame& frame) {
    return FrameOne(std::make_shared<const Frame>(frame));
}

// A honeycomb moved to the right by half of the torus.
Frame moved_hexagons() {
    Foam foam = foam::honeycomb(4, 4);
    for (Vec2& position : foam.positions) {
        position.x() += 0.5 * foam.domain.width;
        position -= foam.domain.translation(foam.domain.cell_of(position));
    }
    return snapshot(foam, 9);
}

TEST(PictureColor, IsTheMeanUnderABubble) {
    const AlbedoOptions options = steps(2);
    double sum = 0.0;
    for (const LinearRgb& color : picture_colors(hexagons(), first_frame(hexagons()), options)) {
        sum += color.r;
        EXPECT_GE(color.r, 0.0);
        EXPECT_LE(color.r, 1.0);
        EXPECT_EQ(color.r, color.b);
    }
    // Half of the torus is white, and all bubbles have the same area.
    EXPECT_NEAR(sum, 8.0, 0.1);
}

TEST(PictureColor, IsKeptForLifeOrSampledInEachFrame) {
    AlbedoOptions options = steps(64);
    const Frame first = hexagons();
    const Frame later = moved_hexagons();
    const PerBubble<LinearRgb> kept = picture_colors(later, first_frame(first), options);
    EXPECT_EQ(kept, picture_colors(first, first_frame(first), options));
    options.picture_sampling = PictureSampling::EveryFrame;
    const PerBubble<LinearRgb> sampled = picture_colors(later, first_frame(first), options);
    EXPECT_NE(kept, sampled);
    EXPECT_EQ(sampled, picture_colors(later, first_frame(later), options));
}

// A bubble that is not in frame 1 has the color under it.
TEST(PictureColor, OfALaterBubbleIsSampledUnderIt) {
    const AlbedoOptions options = steps(64);
    Frame later = hexagons();
    later.bubbles[id_at<BubbleId>(3)].identity = 100;
    EXPECT_EQ(picture_colors(later, first_frame(hexagons()), options),
              picture_colors(hexagons(), first_frame(hexagons()), options));
}

// The picture covers the bounding box of a patch: some bubbles are nearly black, others nearly
// white.
TEST(PictureColor, CoversTheBoundingBoxOfAPatch) {
    PatchOptions seeding;
    seeding.bubbles = 200;
    const Frame patch = snapshot(seed_patch(rectangle_outline(2.0), seeding), 1);
    double darkest = 1.0;
    double lightest = 0.0;
    for (const LinearRgb& color : picture_colors(patch, first_frame(patch), steps(64))) {
        darkest = std::min(darkest, color.g);
        lightest = std::max(lightest, color.g);
    }
    EXPECT_LT(darkest, 0.05);
    EXPECT_GT(lightest, 0.95);
}

// The colors of frame 1 are computed once per picture.
TEST(PictureColor, IsComputedOncePerPicture) {
    const FrameOne first = first_frame(hexagons());
    const AlbedoOptions options = steps(8);
    int computed = 0;
    const auto compute = [&] {
        ++computed;
        return ColorsByIdentity();
    };
    const auto colors = first.colors_under(options.picture.picture, compute);
    EXPECT_EQ(first.colors_under(options.picture.picture, compute), colors);
    EXPECT_EQ(computed, 1);
    first.colors_under(steps(8).picture.picture, compute);
    EXPECT_EQ(computed, 2);
}

TEST(PictureColor, NeedsAPicture) {
    AlbedoOptions options;
    options.color_by = ColorBy::Picture;
    EXPECT_THROW(picture_colors(hexagons(), first_frame(hexagons()), options),
                 std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
