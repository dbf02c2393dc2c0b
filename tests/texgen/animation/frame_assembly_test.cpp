// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/frame_assembly.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace foam::texgen {
namespace {

SimulatedFrame state_of(int number) {
    Frame frame;
    frame.number = number;
    SimulatedFrame state;
    state.frame = std::make_shared<const Frame>(std::move(frame));
    state.effort = {.t1 = number, .t2 = 1, .seconds = 2.0};
    return state;
}

struct Shown {
    int number;
    int next;  // 0 without a next frame
    std::int64_t t1;
    friend bool operator==(const Shown&, const Shown&) = default;
};

std::ostream& operator<<(std::ostream& out, const Shown& shown) {
    return out << shown.number << " -> " << shown.next << ", " << shown.t1 << " T1";
}

// Passes the states that the given frames need to a FrameAssembly. Returns the frames that it hands
// out. Checks the numbers of the states.
std::vector<Shown> assembled(const Preset& preset,
                             const std::vector<int>& numbers,
                             NextFrames next_frames,
                             const std::vector<int>& expected_states) {
    std::vector<Shown> all;
    FrameAssembly assembly(preset, numbers, next_frames, [&](const SimulatedFrame& frame) {
        all.push_back({frame.frame->number, frame.next ? frame.next->number : 0, frame.effort.t1});
    });
    EXPECT_EQ(assembly.states(), expected_states);
    for (const int state : assembly.states()) {
        assembly.add(state_of(state));
    }
    return all;
}

// The effort of state k is k T1s. The effort of a frame is the sum since the frame before it.
TEST(FrameAssembly, HandsOutFramesWithTheEffortSinceTheLast) {
    EXPECT_EQ(assembled({}, {2, 5}, NextFrames::Omitted, {1, 2, 5}),
              (std::vector<Shown>{{2, 0, 3}, {5, 0, 5}}));
}

TEST(FrameAssembly, TheNextFrameNeedsAStateMore) {
    EXPECT_EQ(assembled({}, {2, 4}, NextFrames::Included, {1, 2, 3, 4, 5}),
              (std::vector<Shown>{{2, 3, 3}, {4, 5, 7}}));
}

TEST(FrameAssembly, APatchNeedsItsFirstState) {
    Preset preset;
    preset.shape.kind = FoamKind::Patch;
    EXPECT_EQ(assembled(preset, {3}, NextFrames::Omitted, {1, 3}), (std::vector<Shown>{{3, 0, 4}}));
}

// A cache may contain such efforts.
TEST(FrameAssembly, AddsTheLargestEfforts) {
    constexpr int kMax = std::numeric_limits<std::int32_t>::max();
    std::vector<std::int64_t> counts;
    FrameAssembly assembly({}, {2, 3}, NextFrames::Omitted, [&](const SimulatedFrame& frame) {
        counts.insert(counts.end(), {frame.effort.t1, frame.effort.t2});
    });
    for (const int number : assembly.states()) {
        SimulatedFrame state = state_of(number);
        state.effort.t1 = state.effort.t2 = kMax;
        assembly.add(state);
    }
    EXPECT_EQ(counts, (std::vector<std::int64_t>{2LL * kMax, 2LL * kMax, kMax, kMax}));
}

// A frame has the events since the frame before it. A state that is shown again has none. The
// strain is the strain of the state.
TEST(FrameAssembly, EventsAreHandedOutOnce) {
    Preset preset;
    preset.loop.kind = LoopKind::PingPong;
    preset.frames.count = 6;
    std::vector<std::vector<double>> times;
    std::vector<double> strains;
    FrameAssembly assembly(
        preset, {2, 6, 5, 4}, NextFrames::Omitted, [&](const SimulatedFrame& frame) {
            times.emplace_back();
            for (const TopologyEvent& event : frame.effort.events) {
                times.back().push_back(event.time);
            }
            strains.push_back(frame.effort.strain);
        });
    for (const int number : assembly.states()) {
        SimulatedFrame state = state_of(number);
        state.effort.events.resize(2);
        state.effort.events[0].time = number + 0.25;
        state.effort.events[1].time = number + 0.5;
        state.effort.strain = 0.5 * number;
        assembly.add(state);
    }
    EXPECT_EQ(
        times,
        (std::vector<std::vector<double>>{{1.25, 1.5, 2.25, 2.5}, {}, {3.25, 3.5}, {4.25, 4.5}}));
    EXPECT_EQ(strains, (std::vector<double>{1.0, 1.0, 1.5, 2.0}));
}

// A pingpong of 6 frames shows the states 1 2 3 4 3 2. A state that is shown again adds no effort.
TEST(FrameAssembly, APingPongShowsStatesAgain) {
    Preset preset;
    preset.loop.kind = LoopKind::PingPong;
    preset.frames.count = 6;
    EXPECT_EQ(
        assembled(preset, {1, 2, 3, 4, 5, 6}, NextFrames::Omitted, {1, 2, 3, 4}),
        (std::vector<Shown>{{1, 0, 1}, {2, 0, 2}, {6, 0, 0}, {3, 0, 3}, {5, 0, 0}, {4, 0, 4}}));
}

// Some maps show colors of frame 1, so that every frame has it.
TEST(FrameAssembly, EveryFrameHasFrameOne) {
    std::vector<int> firsts;
    FrameAssembly assembly({}, {2, 3}, NextFrames::Omitted, [&](const SimulatedFrame& frame) {
        firsts.push_back(frame.first->frame().number);
    });
    for (const int state : assembly.states()) {
        assembly.add(state_of(state));
    }
    EXPECT_EQ(firsts, (std::vector<int>{1, 1}));
}

}  // namespace
}  // namespace foam::texgen
