// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/state_codec.h"

#include "core/foam/honeycomb.h"
#include "texgen/cache/byte_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
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

SimulatedFrame honeycomb_state() {
    SimulatedFrame state;
    state.frame = std::make_shared<const Frame>(snapshot(honeycomb(4, 4), 3));
    FoamRecord record;
    record.births.assign(16, 0.0);
    record.changes.assign(16, 0.0);
    state.record = std::make_shared<const FoamRecord>(record);
    return state;
}

TEST(StateCodec, ImpossibleEffortsAreBadContent) {
    const auto reject = [](void (*change)(FrameEffort&)) {
        SimulatedFrame state = honeycomb_state();
        change(state.effort);
        EXPECT_THROW(unpack_state(pack_state(state, {}), {}), BadContent);
    };
    reject([](FrameEffort& effort) { effort.t1 = -1; });
    reject([](FrameEffort& effort) { effort.t2 = std::numeric_limits<std::int32_t>::min(); });
    reject([](FrameEffort& effort) { effort.area_error = std::nan(""); });
    reject([](FrameEffort& effort) { effort.angle_error = -1e300; });
    reject([](FrameEffort& effort) { effort.seconds = std::numeric_limits<double>::infinity(); });
}

TEST(StateCodec, EventsMustBeAmongTheRecordedFrames) {
    const auto unpack = [](int frame, int event_frame) {
        SimulatedFrame state = honeycomb_state();
        FoamRecord record = *state.record;
        record.frame = frame;
        record.events = {{TopologyEventKind::T1, event_frame, {0.5, 0.5}}};
        state.record = std::make_shared<const FoamRecord>(record);
        return unpack_state(pack_state(state, {}), {}).record->events.front().frame;
    };
    EXPECT_EQ(unpack(3, 3), 3);
    EXPECT_EQ(unpack(3, 3 - kRecordedFrames + 1), 3 - kRecordedFrames + 1);
    EXPECT_THROW(unpack(3, 3 - kRecordedFrames), BadContent);
    EXPECT_THROW(unpack(3, 4), BadContent);
    EXPECT_THROW(unpack(std::numeric_limits<int>::max(), -1), BadContent);
    EXPECT_THROW(unpack(std::numeric_limits<int>::min(), 1), BadContent);
}

TEST(StateCodec, MeasurementsRoundTrip) {
    SimulatedFrame state = honeycomb_state();
    state.effort.strain = 1.5;
    state.effort.energy = 30.25;
    state.effort.stress << 0.5, -0.25, -0.25, 0.75;
    state.effort.events = {{TopologyEventKind::T1, 0.25, {1.5, -0.5}, {7, 3, 2, 5}},
                           {TopologyEventKind::T2, 2.0, {0.125, 3.0}, {}}};
    const FrameEffort read = unpack_state(pack_state(state, {}), {}).effort;
    EXPECT_EQ(read.strain, 1.5);
    EXPECT_EQ(read.energy, 30.25);
    EXPECT_EQ(read.stress, state.effort.stress);
    EXPECT_EQ(read.events, state.effort.events);
}

// The measurements without events take 44 bytes: five numbers and a count. Older versions did not
// write them. The stress of a honeycomb of 16 bubbles is isotropic, and its trace is the energy per
// bubble.
TEST(StateCodec, AStateOfAnOlderVersionIsMeasured) {
    const Bytes packed = pack_state(honeycomb_state(), {});
    const FrameEffort read = unpack_state(std::span(packed).first(packed.size() - 44), {}).effort;
    const double energy = std::sqrt(2.0 * std::sqrt(3.0));  // per bubble
    EXPECT_NEAR(read.energy, 16.0 * energy, 1e-12);
    EXPECT_NEAR(read.stress(0, 0), 0.5 * energy, 1e-12);
    EXPECT_EQ(read.strain, 0.0);
    EXPECT_TRUE(read.events.empty());
}

TEST(StateCodec, TruncatedMeasurementsAreBadContent) {
    SimulatedFrame state = honeycomb_state();
    state.effort.events = {{TopologyEventKind::T1, 0.25, {1.5, -0.5}, {7, 3, 2, 5}}};
    const Bytes packed = pack_state(state, {});
    for (std::size_t missing = 1; missing < 80; ++missing) {
        EXPECT_THROW(unpack_state(std::span(packed).first(packed.size() - missing), {}), BadContent)
            << missing;
    }
}

}  // namespace
}  // namespace foam::texgen
