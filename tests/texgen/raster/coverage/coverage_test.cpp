// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

constexpr std::int64_t kFull = std::int64_t{1} << kAreaBits;

template <std::size_t Channels>
struct Span {
    std::size_t begin;
    std::size_t end;
    PixelSums<Channels> sums;

    bool operator==(const Span&) const = default;
};

// Takes a row and returns its spans.
template <std::size_t Channels>
std::vector<Span<Channels>> spans_of(Coverage<Channels>& coverage, int row) {
    std::vector<Span<Channels>> spans;
    coverage.take_row(
        row, {}, [&spans](std::size_t begin, std::size_t end, const PixelSums<Channels>& sums) {
            spans.push_back({begin, end, sums});
        });
    return spans;
}

// Takes a row and returns the sum of each pixel.
std::vector<std::int64_t> take(Coverage<1>& coverage, int row, int width) {
    coverage.finish();
    std::vector<std::int64_t> values;
    for (const Span<1>& span : spans_of(coverage, row)) {
        EXPECT_EQ(span.begin, values.size());
        EXPECT_LT(span.begin, span.end);
        values.resize(span.end, static_cast<std::int64_t>(span.sums[0]));
    }
    EXPECT_EQ(values.size(), static_cast<std::size_t>(width));
    return values;
}

// Adds the straight edges of a closed chain that has `value` on its left.
template <std::size_t Channels>
void add(Coverage<Channels>& coverage,
         const std::vector<SubpixelPoint>& chain,
         SubpixelPoint translation,
         const std::array<double, Channels>& value) {
    SubpixelPoint from = chain.back();
    for (const SubpixelPoint to : chain) {
        typename Coverage<Channels>::Step step;
        for (std::size_t c = 0; c < Channels; ++c) {
            step.across[c] = from.y < to.y ? -value[c] : value[c];
        }
        if (from.y < to.y) {
            coverage.add({from, to, 0.0, {}}, translation, step);
        } else if (to.y < from.y) {
            coverage.add({to, from, 0.0, {}}, translation, step);
        }
        from = to;
    }
}

std::vector<SubpixelPoint> box(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Coverage, HoldsTheAreaOfABoxInEachPixel) {
    // The box is from x = 0.5 to 2.25 pixels, in the lower half of row 0.
    Coverage<1> coverage(4, 1);
    add<1>(coverage, box(512, 0, 2304, 512), {}, {4});
    const std::vector<std::int64_t> expected{kFull, 2 * kFull, kFull / 2, 0};
    EXPECT_EQ(take(coverage, 0, 4), expected);
}

TEST(Coverage, TakingARowClearsIt) {
    Coverage<1> coverage(4, 1);
    add<1>(coverage, box(512, 0, 2304, 512), {}, {4});
    take(coverage, 0, 4);
    EXPECT_EQ(take(coverage, 0, 4), std::vector<std::int64_t>(4, 0));
}

TEST(Coverage, WrapsAroundInX) {
    // The box is from x = 3.5 to 5.5 pixels on a torus 4 pixels wide. It covers half of pixels 3
    // and 1 and all of pixel 0.
    const std::vector<std::int64_t> expected{kFull, kFull / 2, 0, kFull / 2};
    for (const int periods : {-3, -1, 0, 1, 2}) {
        Coverage<1> coverage(4, 1);
        add<1>(coverage, box(3584, 0, 5632, 1024), {periods * 4 * kSubpixel, 0}, {1});
        EXPECT_EQ(take(coverage, 0, 4), expected) << periods;
    }
}

// The first box is from x = -1.5 to 2.25 pixels in a line 4 pixels wide. The parts of boxes beyond
// the ends of the line are not wrapped around.
TEST(Coverage, OfALineEndsAtItsEnds) {
    Coverage<1> coverage(4, 1, RowKind::Line);
    add<1>(coverage, box(-1536, 0, 2304, 1024), {}, {1});
    add<1>(coverage, box(3072, 0, 9000, 1024), {}, {5});
    add<1>(coverage, box(-9000, 0, -2000, 1024), {}, {7});
    add<1>(coverage, box(5000, 0, 6000, 1024), {}, {7});
    const std::vector<std::int64_t> expected{kFull, kFull, kFull / 4, 5 * kFull};
    EXPECT_EQ(take(coverage, 0, 4), expected);
    EXPECT_EQ(take(coverage, 0, 4), std::vector<std::int64_t>(4, 0));
}

TEST(Coverage, AddsUpForABoxWiderThanTheTorus) {
    // The box covers the torus 2.5 times. The last half covers pixels 0 and 1.
    Coverage<1> coverage(4, 1);
    add<1>(coverage, box(0, 0, 10 * kSubpixel, kSubpixel), {}, {1});
    const std::vector<std::int64_t> expected{3 * kFull, 3 * kFull, 2 * kFull, 2 * kFull};
    EXPECT_EQ(take(coverage, 0, 4), expected);
}

TEST(Coverage, LastColumnDoesNotOverflow) {
    Coverage<1> coverage(64, 1);
    add<1>(coverage, box(63 * kSubpixel + 100, 0, 64 * kSubpixel, kSubpixel), {}, {1});
    std::vector<std::int64_t> expected(64, 0);
    expected[63] = kFull - std::int64_t{2} * kSubpixel * 100;
    EXPECT_EQ(take(coverage, 0, 64), expected);
    EXPECT_EQ(take(coverage, 0, 64), std::vector<std::int64_t>(64, 0));
}

TEST(Coverage, ClockwiseSubtracts) {
    Coverage<1> coverage(4, 1);
    add<1>(coverage, box(0, 0, 4096, 1024), {}, {3});
    const std::vector<SubpixelPoint> hole{{1024, 0}, {1024, 1024}, {2048, 1024}, {2048, 0}};
    add<1>(coverage, hole, {}, {3});
    const std::vector<std::int64_t> expected{3 * kFull, 0, 3 * kFull, 3 * kFull};
    EXPECT_EQ(take(coverage, 0, 4), expected);
}

// Two bubbles cover a torus 4 pixels wide: one from x = 1.5 to 3, the other one from x = 3 to 5.5.
// The arc at x = 1.5 is also the right end of the second bubble. In the outline of that bubble it
// is one period further right.
TEST(Coverage, CountsAFilmOnceForBothItsSides) {
    Coverage<1> coverage(4, 1);
    const double first = 3.0;
    const double second = 10.0;
    coverage.add({{3072, 0}, {3072, 1024}, 0.0, {}}, {}, {{second - first}, {}, false});
    coverage.add({{1536, 0}, {1536, 1024}, 0.0, {}}, {}, {{first - second}, {-1.0 * second}, true});
    const auto all = static_cast<std::int64_t>(second) * kFull;
    const std::vector<std::int64_t> expected{all, 13 * kFull / 2, 3 * kFull, all};
    EXPECT_EQ(take(coverage, 0, 4), expected);
}

// The first arc is a quarter of a circle with a radius of 1 pixel around (1, 0), from (2, 0) up to
// (1, 1). The second one is an edge straight down. They cover pi / 4 of pixel 1, with an error of
// half a thousandth. With the chord instead of the arc, they would cover half of it.
TEST(Coverage, HoldsTheAreaOfAQuarterOfACircle) {
    Coverage<1> coverage(4, 1);
    const double sine = std::sin(0.125 * 2.0 * std::numbers::pi);
    coverage.add({{2048, 0}, {1024, 1024}, sine, {}}, {}, {{-1.0}, {}, false});
    coverage.add({{1024, 0}, {1024, 1024}, 0.0, {}}, {}, {{1.0}, {}, false});
    const std::vector<std::int64_t> values = take(coverage, 0, 4);
    EXPECT_NEAR(static_cast<double>(values[1]) / kFull, 0.25 * std::numbers::pi, 1e-3);
    EXPECT_EQ(values[0], 0);
    EXPECT_EQ(values[2], 0);
}

TEST(Coverage, OrderDoesNotMatter) {
    Coverage<3> forward(40, 2);
    Coverage<3> backward(40, 2);
    std::vector<std::vector<SubpixelPoint>> chains(20);
    for (int k = 0; k < 20; ++k) {
        chains[static_cast<std::size_t>(k)] = {
            {977 * k, 31 * k}, {1011 * k + 700, 40}, {900 * k + 100, 1900 - 13 * k}};
    }
    for (std::size_t k = 0; k < chains.size(); ++k) {
        const auto value = [](std::size_t i) {
            return std::array<double, 3>{static_cast<double>(i), 7, -65535};
        };
        add<3>(forward, chains[k], {}, value(k));
        const std::size_t last = chains.size() - 1 - k;
        add<3>(backward, chains[last], {}, value(last));
    }
    forward.finish();
    backward.finish();
    for (int row = 0; row < 2; ++row) {
        EXPECT_EQ(spans_of(forward, row), spans_of(backward, row));
    }
}

// Returns the mean of a pixel with the value `base`, in which a part of the given area, in pixels,
// has the value `other`.
std::uint16_t mean_with(double base, double other, double area) {
    return mean_of(kPixelArea * (base + area * (other - base)));
}

TEST(MeanOf, IsRoundedToNearest) {
    EXPECT_EQ(mean_with(0, 65535, 0.0), 0);
    EXPECT_EQ(mean_with(0, 65535, 1.0), 65535);
    EXPECT_EQ(mean_with(65535, 0, 1.0), 0);
    EXPECT_EQ(mean_with(65535, 0, 0.25), 49151);  // the mean is 49151.25
    EXPECT_EQ(mean_with(100, 103, 0.5), 102);     // the mean is 101.5
    EXPECT_EQ(mean_with(40000, 20000, 0.375), 32500);
}

// If arcs overlap, the areas in a pixel may add up to half a pixel too much or too little.
TEST(MeanOf, IsClampedToTheRangeOfValues) {
    for (const double excess : {1.0 / kPixelArea, 0.001, 0.499}) {
        EXPECT_EQ(mean_with(65535, 0, 1.0 + excess), 0);
        EXPECT_EQ(mean_with(0, 65535, 1.0 + excess), 65535);
        EXPECT_EQ(mean_with(0, 65535, -excess), 0);
        EXPECT_EQ(mean_with(65535, 0, -excess), 65535);
    }
}

}  // namespace
}  // namespace foam::texgen
