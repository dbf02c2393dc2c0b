// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/state_codec.h"

#include "texgen/cache/byte_stream.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace foam::texgen {
namespace {

TEST(StateCodec, NumbersRoundTrip) {
    const std::vector<double> numbers = {0.0, -1.5, 1e300};
    EXPECT_EQ(unpack_numbers(pack_numbers(numbers)), numbers);
    EXPECT_TRUE(unpack_numbers(pack_numbers({})).empty());
}

TEST(StateCodec, ATruncatedStateIsBadContent) {
    const Bytes packed = pack_numbers({1.0, 2.0});
    for (std::size_t size = 0; size < packed.size(); ++size) {
        EXPECT_THROW(unpack_numbers(std::span(packed).first(size)), BadContent) << size;
    }
    EXPECT_THROW(unpack_state({}, {}), BadContent);
}

}  // namespace
}  // namespace foam::texgen
