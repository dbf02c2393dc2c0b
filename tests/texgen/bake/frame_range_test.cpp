// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Frames = std::vector<int>;

TEST(FrameRange, ReadsEveryForm) {
    EXPECT_EQ(parse_frame_range("5"), (Frames{5}));
    EXPECT_EQ(parse_frame_range("3-6"), (Frames{3, 4, 5, 6}));
    EXPECT_EQ(parse_frame_range("1-10x2"), (Frames{1, 3, 5, 7, 9}));
    EXPECT_EQ(parse_frame_range("1-10x3"), (Frames{1, 4, 7, 10}));
    EXPECT_EQ(parse_frame_range("1-10y3"), (Frames{2, 3, 5, 6, 8, 9}));  // not in 1-10x3
    EXPECT_EQ(parse_frame_range("4-1"), (Frames{4, 3, 2, 1}));
    EXPECT_EQ(parse_frame_range("10-1x3"), (Frames{10, 7, 4, 1}));
    EXPECT_EQ(parse_frame_range("5-5"), (Frames{5}));
    EXPECT_EQ(parse_frame_range("1-3,7,9-8"), (Frames{1, 2, 3, 7, 9, 8}));
    EXPECT_EQ(parse_frame_range("1-3x100"), (Frames{1}));
}

TEST(FrameRange, ARepeatedFrameKeepsItsFirstPosition) {
    EXPECT_EQ(parse_frame_range("3,1-5,3"), (Frames{3, 1, 2, 4, 5}));
}

TEST(FrameRange, RejectsEverythingElse) {
    for (const char* text :
         {"",     ",",     "1,",    ",1",      "0",           "-1",        "1-",    "1-0",
          "1--3", "a",     "1-10x", "1x2",     "1-9x0",       "1-9x-1",    "1-9z2", "1 - 3",
          "1.5",  "1-9y1", "+1",    "1-9x2y3", "99999999999", "1-1000001", "0x10"}) {
        EXPECT_THROW(parse_frame_range(text), std::invalid_argument) << text;
    }
}

TEST(FrameRange, ErrorsNameTheRange) {
    try {
        parse_frame_range("1-3z");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "frame range '1-3z': must be a list of ranges such as 5, 1-10, 1-10x2 or "
                     "1-10y3, separated by commas");
    }
}

// Ranges may repeat frames, but not without end.
TEST(FrameRange, TheLengthOfAllRangesIsLimited) {
    std::string text = "1-1000000";
    for (int k = 1; k < 10; ++k) {
        text += ",1-1000000";
    }
    EXPECT_EQ(parse_frame_range(text).size(), 1'000'000U);
    EXPECT_THROW(parse_frame_range(text + ",5"), std::invalid_argument);
}

TEST(FrameRange, IsWrittenShort) {
    EXPECT_EQ(format_frame_range(Frames{1, 2, 3, 4}), "1-4");
    EXPECT_EQ(format_frame_range(Frames{1, 3, 5}), "1-5x2");
    EXPECT_EQ(format_frame_range(Frames{9, 8, 7}), "9-7");
    EXPECT_EQ(format_frame_range(Frames{1, 2}), "1-2");
    EXPECT_EQ(format_frame_range(Frames{1, 5}), "1,5");
    EXPECT_EQ(format_frame_range(Frames{1, 2, 3, 7, 20, 22, 24}), "1-3,7,20-24x2");
    EXPECT_EQ(format_frame_range(Frames{}), "");
}

TEST(FrameRange, ALoopClosesIfItsStepsAreEqual) {
    const auto closes = [](const char* range) { return closes_loop(parse_frame_range(range), 48); };
    for (const char* range : {"1-48", "48-1", "25-72", "1-96", "1-48x2", "2-48x3", "1,25", "7"}) {
        EXPECT_TRUE(closes(range)) << range;
    }
    for (const char* range : {"1-4", "1-47", "1-49", "1-48x5", "1-24,26-48", "1,3"}) {
        EXPECT_FALSE(closes(range)) << range;
    }
}

RC_GTEST_PROP(FrameRange, RoundTrips, ()) {
    const auto frames = *rc::gen::nonEmpty(rc::gen::unique<Frames>(rc::gen::inRange(1, 40)));
    RC_ASSERT(parse_frame_range(format_frame_range(frames)) == frames);
}

TEST(FrameRange, OfNoTextIsAllFrames) {
    EXPECT_EQ(frames_or_all("", 3), (Frames{1, 2, 3}));
    EXPECT_EQ(frames_or_all("2,5", 3), (Frames{2, 5}));
    EXPECT_THROW(frames_or_all("x", 3), std::invalid_argument);
}

RC_GTEST_PROP(FrameRange, XAndYPartitionTheRange, ()) {
    const int last = *rc::gen::inRange(2, 60);
    const int step = *rc::gen::inRange(2, 9);
    const std::string range = "1-" + std::to_string(last);
    Frames both = parse_frame_range(range + "x" + std::to_string(step));
    const Frames others = parse_frame_range(range + "y" + std::to_string(step));
    both.insert(both.end(), others.begin(), others.end());
    std::sort(both.begin(), both.end());
    RC_ASSERT(both == parse_frame_range(range));
}

}  // namespace
}  // namespace foam::texgen
