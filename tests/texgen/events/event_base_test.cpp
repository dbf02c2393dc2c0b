// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/event_base.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

// 7 frames are divided into 3 parts. Part k begins at the frame of index floor(7 k / 3): 0, 2 and
// 4.
TEST(EventBase, PartsOfFramesCoverThemOnce) {
    const FrameSpan frames{10, 16};
    EXPECT_EQ(part_of(frames, 0, 3), (FrameSpan{10, 11}));
    EXPECT_EQ(part_of(frames, 1, 3), (FrameSpan{12, 13}));
    EXPECT_EQ(part_of(frames, 2, 3), (FrameSpan{14, 16}));
    EXPECT_EQ(part_of(frames, 0, 1), frames);
}

TEST(EventBase, NamesBubblesInOneOfThreeWays) {
    EventBase event;
    event.count = 4;
    EXPECT_EQ(event.chosen_count(), 0U);  // all
    event.at = {0.5, 0.5};
    EXPECT_EQ(event.chosen_count(), 1U);
    event.sides = {5, 6};
    EXPECT_EQ(event.chosen_count(), 4U);
    event.bubbles = {1, 2};
    EXPECT_EQ(event.chosen_count(), 2U);
}

TEST(EventBase, FramesAndATimeReplaceEachOther) {
    const Keys<EventBase> keys = time_keys();
    const auto read = [&](const char* name, const char* value, EventBase& event) {
        return find_key(std::span<const Key<EventBase>>(keys), name)
            ->read(read_value(value), event);
    };
    EventBase event;
    EXPECT_TRUE(read("frame", "7", event));
    EXPECT_EQ(event.frames, (FrameSpan{7, 7}));
    EXPECT_TRUE(read("time", "[1, 2.5]", event));
    EXPECT_EQ(event.frames, FrameSpan{});
    EXPECT_EQ(event.time, (std::array{1.0, 2.5}));
    EXPECT_FALSE(read("frames", "[9, 8]", event));
    EXPECT_TRUE(event.time.has_value());
    EXPECT_TRUE(read("frames", "[8, 9]", event));
    EXPECT_FALSE(event.time.has_value());
}

TEST(EventBase, LimitsHoldOnBothSides) {
    test::expect_limits(time_keys(),
                        {{"frame", "1", "2", "100000", "100001"},
                         {"frames", "[1, 4]", "[2, 2]", "[2, 100000]", "[2, 100001]"},
                         {"time", "-1", "0", "1e12", "1.1e12"}});
    test::expect_limits(choice_keys({}),
                        {{"bubble", "-1", "0", "4294967294", "4294967295"},
                         {"at", "[-0.1, 0]", "[0, 0]", "[1, 1]", "[1, 1.1]"},
                         {"sides", "1", "2", "[100, 3]", "[3, 101]"},
                         {"count", "0", "1", "1000000", "1000001"}});
}

TEST(EventBase, ChoicesAreForTheKindsThatTakeThem) {
    const std::vector<EventTraits> kinds{{.name = "a", .meaning = "", .takes_bubbles = true},
                                         {.name = "b", .meaning = "", .takes_position = true}};
    for (const Key<EventBase>& key : choice_keys(kinds)) {
        const bool of_bubbles = key.path == "bubble" || key.path == "sides";
        EXPECT_EQ(key.condition->allows("a"), of_bubbles) << key.path;
        EXPECT_EQ(key.condition->allows("b"), key.path == "at") << key.path;
    }
}

}  // namespace
}  // namespace foam::texgen
