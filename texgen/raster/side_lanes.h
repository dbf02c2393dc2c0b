#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/fixed_point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Eight neighbouring sides of a bubble, counter-clockwise, laid out so that loops go through all
/// of them at once. Lanes beyond the last side have no length and lie where the first side begins.
struct alignas(64) SideLanes {
    static constexpr std::size_t kLanes = 8;
    template <class Value>
    using Lanes = std::array<Value, kLanes>;

    Lanes<double> chord_x;  // pixels
    Lanes<double> chord_y;
    Lanes<double> cosine;  // of half the angle that a side turns
    Lanes<double> sine;
    Lanes<std::int32_t> tail_x;  // subpixels, of the unwrapped bubble
    Lanes<std::int32_t> tail_y;

    void set(std::size_t k, const PixelArc& arc, SubpixelPoint tail) {
        chord_x[k] = arc.chord.x();
        chord_y[k] = arc.chord.y();
        cosine[k] = arc.cosine;
        sine[k] = arc.sine;
        tail_x[k] = tail.x;
        tail_y[k] = tail.y;
    }
    PixelArc arc(std::size_t k) const { return {{chord_x[k], chord_y[k]}, cosine[k], sine[k]}; }
    SubpixelPoint tail(std::size_t k) const { return {tail_x[k], tail_y[k]}; }
};

/// All sides of a bubble.
struct BubbleSides {
    std::span<const SideLanes> lanes;
    std::size_t count = 0;
    Vec2 first{0.0, 0.0};  // the tail of the first without rounding; pixels

    PixelArc arc(std::size_t k) const {
        return lanes[k / SideLanes::kLanes].arc(k % SideLanes::kLanes);
    }
    SubpixelPoint tail(std::size_t k) const {
        return lanes[k / SideLanes::kLanes].tail(k % SideLanes::kLanes);
    }
};

}  // namespace foam::texgen
