// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Arcs in structure-of-arrays layout, in blocks of eight arcs that SIMD code processes at once.
/// Positions are in pixels.
class ArcLanes {
  public:
    static constexpr std::size_t kLanes = 8;
    template <class Value>
    using Lanes = std::array<Value, kLanes>;

    /// The smallest cosine of the half angle of an arc from which distances are measured: such an
    /// arc turns by at most 120 degrees. The class Boundary cuts wider arcs in half until they fit.
    /// The limit must be below 180 degrees. A point faces an arc if it is between the normals at
    /// both ends of the arc. This is tested with two half-planes, and the test fails for arcs that
    /// turn by more than 180 degrees.
    static constexpr double kMinCosine = 0.5;

    /// Eight arcs. Lanes beyond the last arc have unspecified values.
    struct alignas(64) Block {
        Lanes<double> tail_x, tail_y, chord_x, chord_y, cosine, sine;
        Lanes<std::uint8_t> corner;  // 1 if the tail is a corner of more than 180 degrees, else 0
    };

    /// Removes all arcs, and keeps the memory.
    void clear();
    /// Adds an arc that begins at `tail`. `corner` is true if the region on the left of the arcs
    /// (boundary.h) has an inner angle of more than 180 degrees at the tail, so that the tail
    /// itself may be the nearest point of the boundary. Precondition: the chord is longer than
    /// kShortestSide.
    void add(const PixelArc& shape, const Vec2& tail, bool corner);
    /// Adds a copy of the arc k of another ArcLanes.
    void add(const ArcLanes& other, std::size_t k);
    /// Marks the tail of an arc as a corner of more than 180 degrees.
    void set_corner(std::size_t k);

    std::size_t size() const { return size_; }
    std::size_t block_count() const { return (size_ + kLanes - 1) / kLanes; }
    const Block* blocks() const { return blocks_.data(); }

    /// Returns true if the tail of the arc k is a corner of more than 180 degrees.
    bool has_corner(std::size_t k) const { return at(&Block::corner, k) != 0; }
    /// Returns true if the tail of any arc is a corner of more than 180 degrees.
    bool has_corners() const { return has_corners_; }
    Vec2 tail(std::size_t k) const { return {at(&Block::tail_x, k), at(&Block::tail_y, k)}; }
    Vec2 chord(std::size_t k) const { return {at(&Block::chord_x, k), at(&Block::chord_y, k)}; }
    Vec2 head(std::size_t k) const { return tail(k) + chord(k); }

  private:
    template <class Value>
    Value at(Lanes<Value> Block::*member, std::size_t k) const {
        return (blocks_[k / kLanes].*member)[k % kLanes];
    }

    std::size_t size_ = 0;
    bool has_corners_ = false;
    std::vector<Block> blocks_;
};

inline void ArcLanes::clear() {
    size_ = 0;
    has_corners_ = false;
}

inline void ArcLanes::add(const PixelArc& shape, const Vec2& tail, bool corner) {
    const std::size_t k = size_ % kLanes;
    if (size_ / kLanes == blocks_.size()) {
        blocks_.emplace_back();
    }
    Block& block = blocks_[size_ / kLanes];
    block.tail_x[k] = tail.x();
    block.tail_y[k] = tail.y();
    block.chord_x[k] = shape.chord.x();
    block.chord_y[k] = shape.chord.y();
    block.cosine[k] = shape.cosine;
    block.sine[k] = shape.sine;
    block.corner[k] = corner ? 1 : 0;
    has_corners_ = has_corners_ || corner;
    ++size_;
}

inline void ArcLanes::add(const ArcLanes& other, std::size_t k) {
    add({other.chord(k), other.at(&Block::cosine, k), other.at(&Block::sine, k)},
        other.tail(k),
        other.has_corner(k));
}

inline void ArcLanes::set_corner(std::size_t k) {
    blocks_[k / kLanes].corner[k % kLanes] = 1;
    has_corners_ = true;
}

}  // namespace foam::texgen
