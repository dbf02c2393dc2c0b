// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/frame_check.h"

#include "core/files/input_limits.h"
#include "core/foam/honeycomb.h"
#include "texgen/cache/frame_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace foam::texgen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns the fault that is found after a change of a valid frame; empty if there is none.
std::string fault_after(const std::function<void(Frame&)>& change) {
    Frame frame = snapshot(honeycomb(4, 4), 3);
    change(frame);
    return find_frame_fault(frame).value_or("");
}

// Returns the message of the exception that reading such a frame throws. This must not take long,
// whatever the numbers are.
std::string error_after(const std::function<void(Frame&)>& change) {
    Frame frame = snapshot(honeycomb(4, 4), 3);
    change(frame);
    ByteWriter writer;
    write_frame(frame, writer);
    ByteReader reader(writer.bytes());
    try {
        read_frame(reader);
    } catch (const BadContent& error) {
        return error.what();
    }
    return "";
}

TEST(FrameCheck, AValidFrameHasNoFault) {
    EXPECT_EQ(fault_after([](Frame&) {}), "");
}

TEST(FrameCheck, NumbersMustBeFinite) {
    for (const double number : {std::nan(""), kInfinity, -1e300}) {
        EXPECT_NE(error_after([&](Frame& frame) { frame.time = number; }), "");
        EXPECT_NE(error_after([&](Frame& frame) { frame.film_tension = number; }), "");
        EXPECT_NE(error_after([&](Frame& frame) { frame.domain.width = number; }), "");
        EXPECT_NE(error_after([&](Frame& frame) { frame.domain.shear = number; }), "");
        EXPECT_NE(error_after([&](Frame& frame) { frame.positions[JunctionId{5}].y() = number; }),
                  "");
        EXPECT_NE(error_after([&](Frame& frame) { frame.bubbles[BubbleId{2}].pressure = number; }),
                  "");
        EXPECT_NE(
            error_after([&](Frame& frame) { frame.bubbles[BubbleId{2}].target_area = number; }),
            "");
    }
}

TEST(FrameCheck, TheFaultNamesTheElement) {
    EXPECT_EQ(fault_after([](Frame& frame) {
                  frame.positions[JunctionId{5}] = {1e9, 0.5};
              }),
              "junction 5 has an impossible position, (1000000000, 0.5)");
    EXPECT_EQ(fault_after([](Frame& frame) { frame.bubbles[BubbleId{2}].identity = kMaxIdentity; }),
              "the identity 8388608 of a bubble must be below 8388608");
    EXPECT_EQ(fault_after([](Frame& frame) {
                  frame.bubbles[BubbleId{2}].identity = frame.bubbles[BubbleId{7}].identity;
              }),
              "two bubbles have the identity 7");
    EXPECT_EQ(fault_after([](Frame& frame) { frame.bubbles[BubbleId{2}].target_area = 0.0; }),
              "bubble 2 has an impossible target area, 0");
    EXPECT_EQ(fault_after([](Frame& frame) {
                  frame.arcs[FilmId{4}] = {{0.0, 1.0}, std::nan("")};
              }),
              "film 4 has an impossible shape: a chord (0, 1) and a half angle of nan radians");
    EXPECT_EQ(fault_after([](Frame& frame) { frame.domain.height = 1e-9; }).substr(0, 34),
              "the torus has an impossible size, ");
}

TEST(FrameCheck, LoneBubblesMustBeInTheOrderOfTheirIdentities) {
    EXPECT_EQ(fault_after([](Frame& frame) {
                  frame.lone_bubbles = {{100, {0.0, 0.0}, 1.0}, {101, {2.0, 0.0}, 1.0}};
              }),
              "");
    EXPECT_EQ(fault_after([](Frame& frame) {
                  frame.lone_bubbles = {{101, {0.0, 0.0}, 1.0}, {100, {2.0, 0.0}, 1.0}};
              }),
              "the bubbles without neighbors are not in the order of their identities");
}

// Films that wind around the torus many times would exceed the coordinates of the rasterizer.
TEST(FrameCheck, FilmsMustNotBeLongerThanTheTorus) {
    EXPECT_NE(error_after([](Frame& frame) {
                  frame.network.set_offset(forward_side(FilmId{3}), {1'000'000, 0});
              }),
              "");
    EXPECT_NE(fault_after([](Frame& frame) {
                  frame.arcs[FilmId{3}].chord = {100.0 * frame.domain.width, 0.0};
              }),
              "");
}

}  // namespace
}  // namespace foam::texgen
