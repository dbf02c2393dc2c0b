// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/half_bits.h"

#include <Imath/half.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace foam::texgen {
namespace {

// Tests, for each half float, the float with the same value, the float halfway to the next half
// float, and the floats beside it.
TEST(HalfBits, AreThoseOfImath) {
    for (std::uint32_t bits = 0; bits < 0x10000U; ++bits) {
        half exact;
        exact.setBits(static_cast<std::uint16_t>(bits));
        const auto from = std::bit_cast<std::uint32_t>(static_cast<float>(exact));
        for (const std::uint32_t added : {0U, 0x0fffU, 0x1000U, 0x1001U, 0x1fffU, 0x3f800U}) {
            const auto number = std::bit_cast<float>(from + added);
            ASSERT_EQ(half_bits(number), half(number).bits()) << bits << " + " << added;
        }
    }
}

// Tests every 65,537th float.
TEST(HalfBits, AgreeWithImathForFloatsOfAllSizes) {
    for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32U); bits += 65'537) {
        const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        ASSERT_EQ(half_bits(number), half(number).bits()) << bits;
    }
}

}  // namespace
}  // namespace foam::texgen
