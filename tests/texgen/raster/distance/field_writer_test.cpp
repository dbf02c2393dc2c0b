// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/field_writer.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam::texgen {
namespace {

constexpr int kWidth = 50;

DistanceField empty_field() {
    return {Image<std::uint32_t>(kWidth, 3, 1),
            Image<float>(kWidth, 3, 1),
            Image<float>(kWidth, 3, 2),
            Image<float>(kWidth, 3, 1),
            Image<float>(kWidth, 3, 2)};
}

// Spans of 1 to 40 pixels begin at various columns and wrap around the image. No other pixel
// changes.
TEST(FieldWriter, WritesSpansAroundTheImage) {
    for (int left = 0; left < 2 * kWidth; left += 7) {
        for (int count = 1; count <= 40; ++count) {
            DistanceField field = empty_field();
            PixelBatch batch;
            batch.clear(Vec2(20.0, 1.0));
            batch.add_span(2, 1, count);
            batch.measure({}, std::vector<Vec2>{{30.0, 40.0}}, true);
            batch.measure_smooth({}, true);
            FieldWriter writer({.gradient = true, .smooth = SmoothImages::DistanceAndGradient},
                               field);
            writer.write(batch, {left - kWidth, left, 0, 3}, 7);
            for (int y = 0; y < 3; ++y) {
                for (int x = 0; x < kWidth; ++x) {
                    const int k = (x + 2 * kWidth - left - 2) % kWidth;
                    const bool is_written = y == 1 && k < count;
                    ASSERT_EQ(field.ids.pixel(x, y)[0], is_written ? 7U : 0U);
                    const auto at = static_cast<std::size_t>(k);
                    const float distance = is_written ? batch.distance()[at] : 0.0F;
                    const float slope = is_written ? batch.gradient_y()[at] : 0.0F;
                    ASSERT_EQ(field.distance.pixel(x, y)[0], distance);
                    ASSERT_EQ(field.gradient.pixel(x, y)[1], slope);
                    ASSERT_EQ(field.smooth.pixel(x, y)[0], distance);
                    ASSERT_EQ(field.smooth_gradient.pixel(x, y)[1], slope);
                }
            }
        }
    }
}

TEST(FieldWriter, LeavesImagesThatAreNotNeeded) {
    DistanceField field;
    field.ids = Image<std::uint32_t>(kWidth, 1, 1);
    field.distance = Image<float>(kWidth, 1, 1);
    PixelBatch batch;
    batch.clear(Vec2(1.0, 1.0));
    batch.add_span(0, 0, 3);
    batch.measure({}, std::vector<Vec2>{{3.0, 4.0}}, false);
    FieldWriter({}, field).write(batch, {4, 7, 0, 1}, 9);
    EXPECT_EQ(field.ids.pixel(4, 0)[0], 9U);
    EXPECT_EQ(field.ids.pixel(7, 0)[0], 0U);
    EXPECT_TRUE(field.gradient.samples().empty());
}

}  // namespace
}  // namespace foam::texgen
