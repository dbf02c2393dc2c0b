// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pixel_contrast.h"

#include "texgen/maps/map_image.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 6;
const PixelNeighbors kNeighbors({kSide, kSide}, Domain{0.0, 0.0});

// Returns a picture whose brightness is light(x, y), as a fraction of white.
template <class Light>
std::vector<float> picture(const Light& light) {
    std::vector<float> samples;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            samples.push_back(static_cast<float>(kWhite * light(x, y)));
        }
    }
    return samples;
}

const std::vector<float> kFarFromFilms(kSide* kSide, 10.0F);

TEST(PixelContrast, ThereIsNoneInASmoothPicture) {
    const auto light = picture([](int x, int y) { return 0.5 + 0.01 * x - 0.02 * y; });
    EXPECT_TRUE(find_contrasts(light, kFarFromFilms, kNeighbors).empty());
}

// The two columns beside an edge differ from the means of their neighbors.
TEST(PixelContrast, IsOnBothSidesOfAnEdge) {
    const auto light = picture([](int x, int) { return x < 3 ? 0.2 : 0.8; });
    std::vector<std::uint32_t> expected;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        expected.insert(expected.end(), {6 * y + 2, 6 * y + 3});
    }
    EXPECT_EQ(find_contrasts(light, kFarFromFilms, kNeighbors), expected);
}

TEST(PixelContrast, FilmsAreAlwaysFound) {
    const auto light = picture([](int, int) { return 0.5; });
    std::vector<float> distances = kFarFromFilms;
    distances[7] = 0.5F;
    EXPECT_EQ(find_contrasts(light, distances, kNeighbors), std::vector<std::uint32_t>{7});
}

}  // namespace
}  // namespace foam::texgen
