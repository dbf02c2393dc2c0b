#include "texgen/raster/flag_places.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace foam::texgen {
namespace {

TEST(FlagPlaces, AreInOrderAndComplete) {
    std::mt19937_64 random(7);
    std::vector<std::uint64_t> flags(256);
    for (int density = 0; density < 8; ++density) {
        for (std::uint64_t& word : flags) {
            word = density == 7 ? ~std::uint64_t{0} : random();
            for (int k = 0; k < density && density < 7; ++k) {
                word &= random();
            }
        }
        std::vector<std::uint16_t> expected;
        for (std::size_t place = 0; place < flags.size() * kFlagsPerWord; ++place) {
            if ((flags[place / kFlagsPerWord] >> place % kFlagsPerWord & 1) != 0) {
                expected.push_back(static_cast<std::uint16_t>(place));
            }
        }
        std::vector<std::uint16_t> found(expected.size() + kPlacesBeyond);
        ASSERT_EQ(find_places(flags, found.data()), expected.size());
        found.resize(expected.size());
        EXPECT_EQ(found, expected);
        found.assign(expected.size() + kPlacesBeyond, 0);
        ASSERT_EQ(find_places_one_by_one(flags, found.data()), expected.size());
        found.resize(expected.size());
        EXPECT_EQ(found, expected);
    }
}

TEST(FlagPlaces, OfNoneAreNone) {
    std::vector<std::uint16_t> found(kPlacesBeyond);
    EXPECT_EQ(find_places({}, found.data()), 0U);
    EXPECT_EQ(find_places(std::vector<std::uint64_t>(3), found.data()), 0U);
}

}  // namespace
}  // namespace foam::texgen
