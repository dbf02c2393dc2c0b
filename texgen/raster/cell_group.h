#pragma once

#include "texgen/raster/bands.h"
#include "texgen/raster/film_steps.h"
#include "texgen/raster/side_lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Where to go around a bubble of a torus from.
struct TorusBubble {
    BubbleId bubble{};
    HalfEdgeId side{};
    std::uint32_t sides = 0;
    Vec2 first{0.0, 0.0};  // the tail of the side without rounding; pixels
};

/// A bubble of a torus, unwrapped.
struct TorusCell {
    BubbleId bubble{};
    BubbleSides sides;
    RegionExtent extent;  // somewhat too large; begins with the tail of the first side
};

/// Some bubbles that are gone around in step: what follows a side is known once the side is there,
/// which lies anywhere in memory, and is asked for then. Keeps its memory from one time to the
/// next.
class CellGroup {
  public:
    static constexpr std::size_t kMost = 16;

    /// Begins anew with some bubbles, at most kMost of all those that are given. Borrows both.
    void begin(std::span<const TorusBubble> bubbles, const FilmStep* films);
    /// Goes one side further around each of them, if there is one. Other work may be done between
    /// one time and the next, while memory is on its way.
    void advance();
    /// Goes all the way. The cells stand until the group begins anew.
    std::span<const TorusCell> cells();

  private:
    // Around a bubble.
    struct Walk {
        HalfEdgeId side{};
        SubpixelPoint lift;
        SideLanes* to = nullptr;
    };

    void go(Walk& walk) const;

    const FilmStep* films_ = nullptr;
    std::span<const TorusBubble> bubbles_;
    std::size_t step_ = 0;
    std::size_t most_sides_ = 0;
    std::array<Walk, kMost> walks_;
    std::array<TorusCell, kMost> cells_;
    std::vector<SideLanes> lanes_;
};

}  // namespace foam::texgen
