// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/state_codec.h"

#include "core/foam/honeycomb.h"
#include "texgen/cache/byte_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

TEST(StateCodec, NumbersRoundTrip) {
    const std::vector<double> numbers = {0.0, -1.5, 1e15};
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

TEST(StateCodec, NumbersThatAreNotPlausibleAreBadContent) {
    for (const double number : {std::nan(""), std::numeric_limits<double>::infinity(), -1e16}) {
        EXPECT_THROW(unpack_numbers(pack_numbers({1.0, number})), BadContent) << number;
    }
}

TEST(StateCodec, AveragesRoundTrip) {
    SimulatedFrame state;
    const Foam foam = honeycomb(4, 4);
    state.frame = std::make_shared<const Frame>(snapshot(foam, 3));
    FoamRecord record;
    record.births.assign(16, 0.0);
    record.changes.assign(16, 0.0);
    record.averages.bubbles.assign(16, {0.5, 1.25, 6.0});
    record.averages.bubbles[5] = {-0.5, 2.25, 5.5};
    record.averages.mean_area = 1.5;
    state.record = std::make_shared<const FoamRecord>(record);
    const SimulatedFrame read = unpack_state(pack_state(state, {}), {});
    EXPECT_EQ(read.record->averages.bubbles, record.averages.bubbles);
    EXPECT_EQ(read.record->averages.mean_area, 1.5);
}

}  // namespace
}  // namespace foam::texgen
