// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/frame_codec.h"

#include "core/network/validate.h"
#include "texgen/cache/frame_check.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// The topology is rebuilt from the half-edges that leave each junction, in clockwise order. Let a
// and b be two consecutive half-edges of a junction: then b is the `next` of the twin of a. This
// determines all `next` links. One stored half-edge per bubble then determines all of its sides.
// Half-edges that belong to none of the stored bubbles belong to the ghost bubble. A foam without a
// ghost bubble has no such half-edges.
//
// The function `snapshot` computes the geometry from the stored values. The same function made the
// original frame, so both frames are equal to the last bit. Every index is checked, and find_fault
// checks the whole network, so damaged content throws BadContent.

namespace foam::texgen {

namespace {

constexpr BubbleId kNoBubble = kNone<BubbleId>;

std::uint32_t number_of(HalfEdgeId h) {
    return static_cast<std::uint32_t>(h);
}

void write_point(const Vec2& point, ByteWriter& writer) {
    writer.put(point.x());
    writer.put(point.y());
}

Vec2 read_point(ByteReader& reader) {
    const auto x = reader.take<double>();
    return {x, reader.take<double>()};
}

void write_header(const Frame& frame, ByteWriter& writer) {
    writer.put(std::int32_t{frame.number});
    for (const double number : {frame.time,
                                frame.domain.width,
                                frame.domain.height,
                                frame.domain.shear,
                                frame.film_tension}) {
        writer.put(number);
    }
}

void write_topology(const Network& network, ByteWriter& writer) {
    writer.put(static_cast<std::uint32_t>(network.junction_count()));
    for (const JunctionId junction : network.junctions()) {
        for (const HalfEdgeId h : network.leaving(junction)) {
            writer.put(number_of(h));
        }
    }
    for (const FilmId film : network.films()) {
        const LatticeOffset offset = network.offset(forward_side(film));
        writer.put(offset.i);
        writer.put(offset.j);
    }
    writer.put(static_cast<std::uint32_t>(network.bubble_count()));
    for (const BubbleId bubble : network.bubbles()) {
        writer.put(number_of(network.first(bubble)));
    }
    const BubbleId ghost = network.ghost();
    writer.put(static_cast<std::uint8_t>(ghost != kNoBubble));
    if (ghost != kNoBubble) {
        writer.put(number_of(network.first(ghost)));
    }
}

void write_values(const Frame& frame, ByteWriter& writer) {
    for (const FrameBubble& bubble : frame.bubbles) {
        writer.put(bubble.identity);
    }
    for (const FrameBubble& bubble : frame.bubbles) {
        writer.put(bubble.target_area);
    }
    for (const FrameBubble& bubble : frame.bubbles) {
        writer.put(bubble.pressure);
    }
    for (const Vec2& position : frame.positions) {
        write_point(position, writer);
    }
}

// Writes the half angles of outer films, and the lone bubbles. The half angles of all other films
// are not stored, because they follow from the pressures.
void write_patch(const Frame& frame, ByteWriter& writer) {
    for (const FilmId film : frame.network.films()) {
        if (frame.network.is_outer(film)) {
            writer.put(frame.arcs[film].half_angle);
        }
    }
    writer.put(static_cast<std::uint32_t>(frame.lone_bubbles.size()));
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        writer.put(bubble.identity);
        write_point(bubble.center, writer);
        writer.put(bubble.target_area);
    }
}

/// Reads a frame in the order in which write_frame writes it.
class FrameReader {
  public:
    explicit FrameReader(ByteReader& reader) : reader_(reader) {}

    Frame read() {
        const int number = reader_.take<std::int32_t>();
        for (double* const value : {&foam_.time,
                                    &foam_.domain.width,
                                    &foam_.domain.height,
                                    &foam_.domain.shear,
                                    &foam_.film_tension}) {
            *value = reader_.take<double>();
        }
        read_junctions();
        read_bubbles();
        check();
        read_values();
        if (network().ghost() != kNoBubble) {
            read_patch();
        }
        Frame frame = snapshot(foam_, number);
        if (const auto fault = find_frame_fault(frame)) {
            throw BadContent(*fault);
        }
        return frame;
    }

  private:
    Network& network() { return foam_.network; }
    std::size_t half_edges() { return 2 * network().film_count(); }

    HalfEdgeId read_half_edge() { return id_at<HalfEdgeId>(reader_.take_index(half_edges())); }

    // Reads a half-edge that leaves a junction. Throws BadContent if the half-edge has already been
    // read.
    HalfEdgeId take_side() {
        const HalfEdgeId h = read_half_edge();
        if (taken_[index_of(h)]) {
            throw BadContent("a half-edge leaves two junctions");
        }
        taken_[index_of(h)] = true;
        return h;
    }

    // Reads the three half-edges that leave each junction and links them: each is the `next` of the
    // twin of the previous one, cyclically. Then reads the lattice offsets of the films.
    void read_junctions() {
        const std::size_t count = reader_.take_count(3 * sizeof(std::uint32_t));
        // Three films end at each junction and each film has two ends, so there are three films for
        // every two junctions.
        if (count % 2 != 0) {
            throw BadContent("the number of junctions is odd");
        }
        for (std::size_t k = 0; k < count; ++k) {
            network().add_junction();
        }
        for (std::size_t k = 0; k < 3 * count / 2; ++k) {
            network().add_film();
        }
        taken_.assign(half_edges(), false);
        for (std::size_t k = 0; k < count; ++k) {
            const std::array leaving{take_side(), take_side(), take_side()};
            // Each call of set_tail makes its half-edge the outgoing() of the junction. The three
            // half-edges are visited in reverse order, so that the one that was read first remains
            // outgoing().
            for (const std::size_t i : {2U, 1U, 0U}) {
                network().set_tail(leaving[i], id_at<JunctionId>(k));
                network().set_next(twin(leaving[i]), leaving[(i + 1) % 3]);
            }
        }
        for (const FilmId film : network().films()) {
            const auto i = reader_.take<std::int32_t>();
            network().set_offset(forward_side(film), {i, reader_.take<std::int32_t>()});
        }
    }

    void read_bubbles() {
        const std::size_t count = reader_.take_count(sizeof(std::uint32_t));
        for (std::size_t k = 0; k < count; ++k) {
            claim_loop(network().add_bubble(), read_half_edge());
        }
        if (reader_.take<std::uint8_t>() != 0) {
            read_ghost();
        } else if (!unclaimed().empty()) {
            throw BadContent("a half-edge belongs to no bubble");
        }
    }

    // Assigns a closed chain of half-edges to a bubble: `first`, the `next` of `first`, and so on.
    void claim_loop(BubbleId bubble, HalfEdgeId first) {
        network().set_first(bubble, first);
        int sides = 0;
        HalfEdgeId h = first;
        do {
            if (network().left(h) != kNoBubble) {
                throw BadContent("two bubbles share a half-edge");
            }
            network().set_left(h, bubble);
            h = network().next(h);
            ++sides;
        } while (h != first);
        network().set_sides(bubble, sides);
    }

    // Assigns all remaining half-edges to the ghost bubble and reads its first half-edge.
    void read_ghost() {
        const BubbleId ghost = network().add_ghost();
        const std::vector<HalfEdgeId> sides = unclaimed();
        for (const HalfEdgeId h : sides) {
            network().set_left(h, ghost);
        }
        const auto first = id_at<HalfEdgeId>(reader_.take<std::uint32_t>());
        if (std::ranges::find(sides, first) == sides.end() && !sides.empty()) {
            throw BadContent("the first half-edge of the ghost bubble belongs to another bubble");
        }
        network().set_first(ghost, sides.empty() ? kNone<HalfEdgeId> : first);
        network().set_sides(ghost, static_cast<int>(sides.size()));
    }

    // Returns the half-edges that belong to no bubble yet.
    std::vector<HalfEdgeId> unclaimed() {
        std::vector<HalfEdgeId> sides;
        for (std::size_t k = 0; k < half_edges(); ++k) {
            const auto h = id_at<HalfEdgeId>(k);
            if (network().left(h) == kNoBubble) {
                sides.push_back(h);
            }
        }
        return sides;
    }

    void check() {
        if (const auto fault = find_fault(foam_.network)) {
            throw BadContent("the foam is not valid: " + *fault);
        }
    }

    void read_values() {
        const std::size_t bubbles = network().bubble_count();
        for (std::size_t k = 0; k < bubbles; ++k) {
            foam_.identities.push_back(reader_.take<std::uint32_t>());
        }
        for (std::size_t k = 0; k < bubbles; ++k) {
            foam_.target_areas.push_back(reader_.take<double>());
        }
        for (std::size_t k = 0; k < bubbles; ++k) {
            foam_.pressures.push_back(reader_.take<double>());
        }
        for (std::size_t k = 0; k < network().junction_count(); ++k) {
            foam_.positions.push_back(read_point(reader_));
        }
    }

    void read_patch() {
        complete_patch(foam_);
        for (const FilmId film : network().films()) {
            if (network().is_outer(film)) {
                foam_.half_angles[film] = reader_.take<double>();
            }
        }
        constexpr std::size_t kLoneBubbleBytes = sizeof(std::uint32_t) + 3 * sizeof(double);
        const std::size_t lone = reader_.take_count(kLoneBubbleBytes);
        for (std::size_t k = 0; k < lone; ++k) {
            const auto identity = reader_.take<std::uint32_t>();
            const Vec2 center = read_point(reader_);
            foam_.lone_bubbles.push_back({identity, center, reader_.take<double>()});
        }
    }

    ByteReader& reader_;
    Foam foam_;
    std::vector<bool> taken_;  // indexed by half-edge; true if it was read
};

}  // namespace

void write_frame(const Frame& frame, ByteWriter& writer) {
    write_header(frame, writer);
    write_topology(frame.network, writer);
    write_values(frame, writer);
    if (frame.network.ghost() != kNoBubble) {
        write_patch(frame, writer);
    }
}

Frame read_frame(ByteReader& reader) {
    return FrameReader(reader).read();
}

}  // namespace foam::texgen
