// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_sampler.h"

#include "tests/support/sample_foams.h"
#include "texgen/maps/occlusion.h"
#include "texgen/raster/coords/raster_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 64;
constexpr int kFiner = 3;

class SamplerOfEveryProfile : public testing::TestWithParam<ReliefProfile> {};

INSTANTIATE_TEST_SUITE_P(Profiles,
                         SamplerOfEveryProfile,
                         testing::Values(ReliefProfile::Dome,
                                         ReliefProfile::Ridge,
                                         ReliefProfile::Wet));

// The points in a pixel at multiples of a third of a pixel are the centers of pixels of a grid that
// is three times finer. Estimates differ from the relief there only near junctions, where more than
// one film is near.
TEST_P(SamplerOfEveryProfile, AgreesWithAFinerGrid) {
    const Frame frame =
        foam::test::fitted_frame(foam::test::polydisperse_foam(12, 1), kSize, kSize);
    const FoamRecord record;
    const ReliefOptions options{.profile = GetParam(), .width = 0.2};
    const MazeOptions maze;
    const RasterGrid grid{kSize, kSize};
    FrameLayers layers(
        {frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}}, grid, 1);
    FrameLayers finer({frame, record, nullptr, {.smooth = SmoothImages::DistanceAndGradient}},
                      {kFiner * kSize, kFiner * kSize},
                      1);
    const Relief relief(layers, {options, maze}, ReliefSection::kSkyReach);
    const Relief fine(finer, {options, maze}, ReliefSection::kSkyReach);
    const VisibleSky sky(relief.section(), relief.strength(), 1.0);
    const PixelSlopes slopes = relief.slopes();
    const PixelSlopes fine_slopes = fine.slopes();
    const Image<float> fine_sky = occlusion_of(fine, sky.lookup());
    const PixelNeighbors neighbors(grid, frame.domain);
    ReliefSampler sampler(relief, slopes, sky.lookup(), neighbors);
    std::vector<std::uint32_t> pixels;
    for (std::uint32_t k = 0; k < kSize * kSize; ++k) {
        pixels.push_back(k);
    }
    sampler.choose(pixels);
    std::vector<float> x(pixels.size());
    std::vector<float> y(pixels.size());
    std::vector<float> visible(pixels.size());
    std::vector<double> errors;
    for (int j = 0; j < kFiner * kFiner; ++j) {
        const int column = j % kFiner;
        const int row = j / kFiner;
        sampler.write({(column - 1.0) / kFiner, (row - 1.0) / kFiner}, {x, y, visible});
        for (int k = 0; k < kSize * kSize; ++k) {
            const auto at = static_cast<std::size_t>((k / kSize * kFiner + row) * kFiner * kSize +
                                                     k % kSize * kFiner + column);
            const auto index = static_cast<std::size_t>(k);
            const double slope = std::hypot(x[index] - fine_slopes.x.samples()[at],
                                            y[index] - fine_slopes.y.samples()[at]);
            const double sky_error = std::abs(visible[index] - fine_sky.samples()[at]);
            errors.push_back(std::max(slope, sky_error));
        }
    }
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() / 2], 0.01);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.15);
}

}  // namespace
}  // namespace foam::texgen
