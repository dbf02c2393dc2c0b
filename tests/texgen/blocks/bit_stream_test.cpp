// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bit_stream.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(BitStream, TheFirstBitIsTheLowestBitOfTheFirstByte) {
    BitWriter bits;
    bits.write(1, 1);
    bits.write(0b1011, 4);
    bits.write(0b10110, 5);
    EXPECT_EQ(bits.bytes()[0], 0b110'1011'1);
    EXPECT_EQ(bits.bytes()[1], 0b10);
}

TEST(BitStream, IsReadAsItWasWritten) {
    BitWriter bits;
    for (int k = 0; k < 16; ++k) {
        bits.write(k * 5, 7);
    }
    BitReader reader(bits.bytes());
    for (int k = 0; k < 16; ++k) {
        EXPECT_EQ(reader.read(7), k * 5);
    }
}

}  // namespace
}  // namespace foam::texgen
