// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/frame_codec.h"

#include "texgen/animation/simulation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {
namespace {

void expect_same_network(const Network& a, const Network& b) {
    ASSERT_EQ(a.junction_count(), b.junction_count());
    ASSERT_EQ(a.film_count(), b.film_count());
    ASSERT_EQ(a.bubble_slots(), b.bubble_slots());
    EXPECT_EQ(a.ghost(), b.ghost());
    for (const FilmId film : a.films()) {
        EXPECT_EQ(a.offset(forward_side(film)), b.offset(forward_side(film)));
        for (const HalfEdgeId h : {forward_side(film), twin(forward_side(film))}) {
            EXPECT_EQ(a.tail(h), b.tail(h));
            EXPECT_EQ(a.left(h), b.left(h));
            EXPECT_EQ(a.next(h), b.next(h));
        }
    }
    for (const JunctionId junction : a.junctions()) {
        EXPECT_EQ(a.outgoing(junction), b.outgoing(junction));
    }
    for (std::size_t k = 0; k < a.bubble_slots(); ++k) {
        EXPECT_EQ(a.first(id_at<BubbleId>(k)), b.first(id_at<BubbleId>(k)));
        EXPECT_EQ(a.sides(id_at<BubbleId>(k)), b.sides(id_at<BubbleId>(k)));
    }
}

// Expects that two frames are equal to the last bit.
void expect_same(const Frame& a, const Frame& b) {
    EXPECT_EQ(a.number, b.number);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.domain.width, b.domain.width);
    EXPECT_EQ(a.domain.height, b.domain.height);
    EXPECT_EQ(a.domain.shear, b.domain.shear);
    EXPECT_EQ(a.film_tension, b.film_tension);
    expect_same_network(a.network, b.network);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.lone_bubbles, b.lone_bubbles);
    for (const FilmId film : a.network.films()) {
        EXPECT_EQ(a.arcs[film].chord, b.arcs[film].chord);
        EXPECT_EQ(a.arcs[film].half_angle, b.arcs[film].half_angle);
    }
    for (const BubbleId bubble : a.network.bubbles()) {
        EXPECT_EQ(a.bubbles[bubble].identity, b.bubbles[bubble].identity);
        EXPECT_EQ(a.bubbles[bubble].area, b.bubbles[bubble].area);
        EXPECT_EQ(a.bubbles[bubble].target_area, b.bubbles[bubble].target_area);
        EXPECT_EQ(a.bubbles[bubble].pressure, b.bubbles[bubble].pressure);
    }
}

Bytes written(const Frame& frame) {
    ByteWriter writer;
    write_frame(frame, writer);
    return writer.bytes();
}

Frame read_back(const Frame& frame) {
    const Bytes bytes = written(frame);
    ByteReader reader(bytes);
    Frame read = read_frame(reader);
    EXPECT_TRUE(reader.is_at_end());
    return read;
}

Preset small_preset(FoamKind kind) {
    Preset preset;
    preset.shape.kind = kind;
    preset.seeding.bubbles = 15;
    preset.coarsening.kappa = 0.3;
    return preset;
}

/// Expects that the first `frames` frames of a coarsening foam are equal after encoding and
/// decoding.
void expect_all_same(FoamKind kind, int frames) {
    Simulation simulation(small_preset(kind), 1);
    for (int k = 0; k < frames; ++k) {
        ASSERT_TRUE(simulation.advance());
        const Frame frame = simulation.frame();
        expect_same(read_back(frame), frame);
    }
}

TEST(FrameCodec, ATorusRoundTripsBitForBit) {
    expect_all_same(FoamKind::Torus, 8);
}

// The patch coarsens until only lone bubbles are left, and then none.
TEST(FrameCodec, APatchRoundTripsBitForBit) {
    expect_all_same(FoamKind::Patch, 40);
}

TEST(FrameCodec, TakesAboutAHundredBytesABubble) {
    Preset preset = small_preset(FoamKind::Torus);
    preset.seeding.bubbles = 400;
    Simulation simulation(preset, 1);
    ASSERT_TRUE(simulation.advance());
    const Frame frame = simulation.frame();
    EXPECT_LT(written(frame).size() / frame.bubbles.size(), 110U);
}

// Frames that are truncated, or whose topology is damaged, are rejected. The reader never reads
// beyond the end.
TEST(FrameCodec, RejectsInvalidFoams) {
    Simulation simulation(small_preset(FoamKind::Patch), 1);
    ASSERT_TRUE(simulation.advance());
    const Bytes good = written(simulation.frame());
    for (std::size_t size = 0; size < good.size(); ++size) {
        ByteReader reader({good.data(), size});
        EXPECT_THROW(read_frame(reader), BadContent) << size;
    }
    constexpr std::size_t kTopology = 4 + 5 * sizeof(double);
    for (std::size_t offset = kTopology; offset < kTopology + 200; ++offset) {
        Bytes bad = good;
        bad[offset] ^= std::byte{0x11};
        ByteReader reader(bad);
        EXPECT_THROW(read_frame(reader), BadContent) << offset;
    }
}

}  // namespace
}  // namespace foam::texgen
