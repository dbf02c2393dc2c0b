#include "texgen/raster/coverage/coverage_sums.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

constexpr std::int32_t kPixel = 1 << kAreaBits;

// A pixel of a value, of which some area has another.
template <class Sums>
std::int32_t mean_of(std::int32_t base, std::int32_t other, std::int32_t area) {
    typename Sums::Sum sum{Sums::start(base)};
    sum[0] += Sums::of_area(area) * Sums::of_value(other - base);
    return Sums::mean(sum[0]);
}

template <class Sums>
void expect_means() {
    EXPECT_EQ(mean_of<Sums>(0, 65535, 0), 0);
    EXPECT_EQ(mean_of<Sums>(0, 65535, kPixel), 65535);
    EXPECT_EQ(mean_of<Sums>(65535, 0, kPixel), 0);
    EXPECT_EQ(mean_of<Sums>(65535, 0, kPixel / 4), 49151);  // of 49151.25
    EXPECT_EQ(mean_of<Sums>(100, 103, kPixel / 2), 102);    // of 101.5
    EXPECT_EQ(mean_of<Sums>(40000, 20000, 3 * kPixel / 8), 32500);
}

TEST(CoverageSums, GiveTheNearestMean) {
    expect_means<ExactSums<1>>();
    expect_means<SmallSums<1>>();
}

// Where arcs overlap, up to half a pixel too much or too little counts.
TEST(CoverageSums, HoldMeansWithinTheirRange) {
    for (const std::int32_t excess : {1, kPixel / 1000, kPixel / 2 - kPixel / 1000}) {
        EXPECT_EQ(mean_of<ExactSums<1>>(65535, 0, kPixel + excess), 0);
        EXPECT_EQ(mean_of<SmallSums<1>>(65535, 0, kPixel + excess), 0);
        EXPECT_EQ(mean_of<SmallSums<1>>(0, 65535, kPixel + excess), 65535);
        EXPECT_EQ(mean_of<SmallSums<1>>(0, 65535, -excess), 0);
        EXPECT_EQ(mean_of<SmallSums<1>>(65535, 0, -excess), 65535);
    }
}

// Parts of a height, which is whole subpixels, add up to all of it.
TEST(CoverageSums, KeepHeightsExact) {
    using Sums = SmallSums<1>;
    for (std::int32_t height = 0; height <= kSubpixel; ++height) {
        const std::int32_t whole = 2 * kSubpixel * height;
        EXPECT_EQ(Sums::of_area(whole) << (kAreaBits - Sums::kPixelBits),
                  static_cast<std::uint32_t>(whole));
        EXPECT_EQ(Sums::of_area(-whole), 0 - Sums::of_area(whole));
    }
}

}  // namespace
}  // namespace foam::texgen
