// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/color_loops.h"

#include "core/parallel/simd_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ColorLoops, ColorsAreRoundedAndClampedAndOpacitiesKept) {
    Image<std::uint16_t> image(2, 1, 4);
    std::ranges::copy(std::array<std::uint16_t, 8>{10, 20, 30, 40, 50, 60, 70, 80},
                      image.samples().begin());
    change_colors(image, [](const std::array<float, 3>& color, std::size_t k) {
        return std::array{
            color[0] + 0.5F, color[1] - 100.0F, color[2] + 70000.0F * static_cast<float>(k)};
    });
    const std::vector<std::uint16_t> expected = {11, 0, 30, 40, 51, 0, 65535, 80};
    EXPECT_TRUE(std::ranges::equal(image.samples(), expected));
}

// Many pixels, so that whole vectors and rests of vectors are used.
TEST(ColorLoops, EveryLevelMixesTheSameColors) {
    Image<float> weights(101, 3, 1);
    for (std::size_t k = 0; k < weights.samples().size(); ++k) {
        weights.samples()[k] = static_cast<float>(k) / 302.0F;
    }
    std::vector<Image<std::uint16_t>> images;
    for (const SimdLevel level : available_simd_levels()) {
        const ForcedSimdLevel forced(level);
        Image<std::uint16_t> image(101, 3, 3);
        mix_in({1.0, 0.5, 0.0}, weights, image);
        images.push_back(image);
    }
    for (const Image<std::uint16_t>& image : images) {
        EXPECT_EQ(image, images.front());
    }
    for (std::size_t k = 0; k < weights.samples().size(); ++k) {
        EXPECT_NEAR(images[0].samples()[3 * k], 65535.0 * static_cast<double>(k) / 302.0, 0.51);
        EXPECT_EQ(images[0].samples()[3 * k + 2], 0);
    }
}

}  // namespace
}  // namespace foam::texgen
