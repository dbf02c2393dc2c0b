// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/frame_store.h"

#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace foam::texgen {
namespace {

constexpr std::size_t kPlenty = 1UL << 30;

// Returns a small foam of four frames; `set` changes it.
Preset small(std::initializer_list<std::string> sets = {}) {
    Preset preset = load_preset("sea_foam");
    std::vector<Assignment> assignments{read_set_argument("foam.bubbles=40"),
                                        read_set_argument("frames.count=4"),
                                        read_set_argument("image.size=[64, 64]")};
    for (const std::string& set : sets) {
        assignments.push_back(read_set_argument(set));
    }
    assign(preset, assignments);
    return preset;
}

// Returns a foam of twelve frames whose loop takes much longer to close than the tests.
Preset slow() {
    return small({"foam.bubbles=300", "frames.count=12", "loop.kind=boil"});
}

// The memory that the store counts for a state of 100 bubbles, in bytes.
constexpr std::size_t kStateOf100 = 100UL * 2500UL;

SimulationState complete_state(FrameStore& store, const Preset& preset, const std::string& page) {
    while (true) {
        const SimulationState state = store.want(preset, page);
        if (state.status != SimulationState::Status::Running) {
            return state;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

// Asks for a frame of slow() in another thread.
std::future<SimulatedFrame> frame_of_slow(FrameStore& store) {
    return std::async(std::launch::async,
                      [&] { return store.frame(slow(), 1, NextFrames::Included, "page"); });
}

// Returns why a frame is not simulated.
std::string replacement(std::future<SimulatedFrame>& waiting) {
    try {
        waiting.get();
        return "it is simulated";
    } catch (const SimulationStopped& error) {
        return error.what();
    }
}

std::vector<double> areas_of(const SimulatedFrame& shown) {
    std::vector<double> areas;
    for (const FrameBubble& bubble : shown.frame->bubbles) {
        areas.push_back(bubble.area);
    }
    return areas;
}

TEST(FrameStore, FramesEqualThoseOfASimulation) {
    for (const char* kind : {"breathe", "none", "flow", "shear"}) {
        const Preset preset = small({std::string("loop.kind=") + kind});
        FrameStore store(kPlenty);
        int compared = 0;
        simulation_of(preset, 0)(
            {1, 2, 3, 4},
            NextFrames::Included,
            [&](const SimulatedFrame& expected) {
                const SimulatedFrame kept =
                    store.frame(preset, expected.frame->number, NextFrames::Included, "page");
                EXPECT_EQ(areas_of(kept), areas_of(expected)) << kind;
                EXPECT_EQ(kept.frame->positions, expected.frame->positions) << kind;
                EXPECT_EQ(kept.next->positions, expected.next->positions) << kind;
                EXPECT_EQ(kept.fade_growth, expected.fade_growth) << kind;
                ++compared;
            },
            {});
        EXPECT_EQ(compared, 4) << kind;
    }
}

TEST(FrameStore, CountsFramesAndBecomesComplete) {
    FrameStore store(kPlenty);
    const Preset preset = small();
    const SimulationState state = complete_state(store, preset, "page");
    EXPECT_EQ(state.status, SimulationState::Status::Complete);
    EXPECT_EQ(state.done, 4);
    EXPECT_EQ(state.total, 4);
    ASSERT_TRUE(state.closing_error);
    EXPECT_LT(*state.closing_error, 1e-9);
}

TEST(FrameStore, ThePictureOptionsDoNotNeedAnotherSimulation) {
    FrameStore store(kPlenty);
    complete_state(store, small(), "page");
    const SimulationState state = store.want(small({"relief.width=0.3"}), "page");
    EXPECT_EQ(state.status, SimulationState::Status::Complete);
}

TEST(FrameStore, AnotherFoamStopsTheFirstOne) {
    FrameStore store(kPlenty);
    auto waiting = frame_of_slow(store);
    while (store.want(slow(), "page").progress.done == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    complete_state(store, small(), "page");
    EXPECT_EQ(replacement(waiting), "the page has asked for another foam");
}

TEST(FrameStore, AnotherPageDoesNotStopASimulation) {
    FrameStore store(kPlenty);
    const Preset first = small({"foam.seed=5"});
    store.want(first, "one");
    complete_state(store, small({"foam.seed=6"}), "two");
    EXPECT_EQ(complete_state(store, first, "one").status, SimulationState::Status::Complete);
}

// slow() needs 13 states: those of its frames, and the one after them.
TEST(FrameStore, AFoamOfAnotherPageMayNeedTheMemory) {
    FrameStore store(14 * 3 * kStateOf100);
    auto waiting = frame_of_slow(store);
    do {
        store.want(small({"foam.bubbles=300"}), "other");
    } while (waiting.wait_for(std::chrono::milliseconds(2)) == std::future_status::timeout);
    EXPECT_EQ(replacement(waiting), "a foam that was asked for later has replaced this one");
}

// slow() needs the memory of 39 states of 100 bubbles. The others need that of 5 and 10 states.
TEST(FrameStore, ForgetsACompleteFoamBeforeItStopsASimulation) {
    FrameStore store(50 * kStateOf100);
    const Preset complete = small({"foam.bubbles=100"});
    complete_state(store, complete, "other");
    store.want(slow(), "page");
    store.want(complete, "other");
    EXPECT_TRUE(store.source(complete));
    store.want(small({"foam.bubbles=200"}), "other");
    EXPECT_FALSE(store.source(complete));
}

TEST(FrameStore, AFailureHasAMessage) {
    FrameStore store(kPlenty);
    const Preset preset = small({"loop.cycles=1", "loop.amplitude=0.4"});
    const SimulationState state = complete_state(store, preset, "page");
    EXPECT_EQ(state.status, SimulationState::Status::Failed);
    EXPECT_NE(state.message.find("the loop does not close"), std::string::npos);
    EXPECT_THROW(store.frame(preset, 1, NextFrames::Included, "page"), SimulationFailed);
}

TEST(FrameStore, KeepsOnlyTheFramesThatFit) {
    // Three states of 40 bubbles: two frames, and the state after them.
    FrameStore store(3 * 40 * 2500 + 10);
    const Preset preset = small();
    const SimulationState state = complete_state(store, preset, "page");
    EXPECT_EQ(state.total, 2);
    EXPECT_EQ(store.frame(preset, 2, NextFrames::Omitted, "page").frame->number, 2);
    EXPECT_THROW(store.frame(preset, 3, NextFrames::Included, "page"), SimulationFailed);
    EXPECT_FALSE(store.source(preset));
}

TEST(FrameStore, IsASourceOfAllFramesOnceComplete) {
    FrameStore store(kPlenty);
    const Preset preset = small();
    EXPECT_FALSE(store.source(preset));
    complete_state(store, preset, "page");
    const FrameSource source = store.source(small({"relief.width=0.3"}));
    ASSERT_TRUE(source);
    std::vector<int> numbers;
    const RunOutcome outcome =
        source({2, 4},
               NextFrames::Omitted,
               [&](const SimulatedFrame& shown) { numbers.push_back(shown.frame->number); },
               {});
    EXPECT_EQ(outcome.status, RunStatus::Complete);
    EXPECT_EQ(numbers, (std::vector<int>{2, 4}));
}

TEST(FrameStore, ADraftShowsTheSeededFoam) {
    FrameStore store(kPlenty);
    const Preset still = small({"loop.kind=none", "loop.current=0"});
    EXPECT_EQ(areas_of(store.draft(small())),
              areas_of(store.frame(still, 1, NextFrames::Included, "page")));
}

// Drafts may use a quarter of the memory: those of two foams of 40 bubbles here, or of one of 100.
TEST(FrameStore, KeepsOnlyTheDraftsThatFit) {
    FrameStore store(4 * kStateOf100);
    const auto first = store.draft(small()).frame;
    const auto second = store.draft(small({"foam.seed=6"})).frame;
    EXPECT_EQ(store.draft(small()).frame, first);
    store.draft(small({"foam.bubbles=100"}));
    EXPECT_NE(store.draft(small()).frame, first);
}

TEST(FrameStore, StopEndsAllThatWait) {
    FrameStore store(kPlenty);
    auto waiting = frame_of_slow(store);
    store.stop();
    EXPECT_EQ(replacement(waiting), "the studio ends");
}

}  // namespace
}  // namespace foam::texgen
