#include "texgen/raster/bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Bins, HoldThingsInTheirOrder) {
    constexpr std::size_t kBins = 7;
    constexpr std::size_t kParts = 5;
    constexpr std::size_t kPerPart = 40;
    const auto bin_of = [](std::size_t thing) { return thing * thing % kBins; };
    const auto visit = [&](std::size_t part, const auto& put) {
        for (std::size_t k = part * kPerPart; k < (part + 1) * kPerPart; ++k) {
            put(bin_of(k), k);
        }
    };
    for (const int threads : {1, 2, 9}) {
        const auto all = into_bins<std::size_t>(kBins, kParts, threads, visit);
        ASSERT_EQ(all.ends.size(), kBins + 1);
        EXPECT_EQ(all.of(0, kBins).size(), kParts * kPerPart);
        for (std::size_t bin = 0; bin < kBins; ++bin) {
            EXPECT_TRUE(std::ranges::is_sorted(all.of(bin, bin + 1)));
            for (const std::size_t thing : all.of(bin, bin + 1)) {
                EXPECT_EQ(bin_of(thing), bin);
            }
        }
    }
}

TEST(Bins, MayAllBeEmpty) {
    const auto all = into_bins<int>(3, 0, 2, [](std::size_t, const auto&) {});
    EXPECT_TRUE(all.of(0, 3).empty());
}

}  // namespace
}  // namespace foam::texgen
