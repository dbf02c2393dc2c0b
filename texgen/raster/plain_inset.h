#pragma once

#include "texgen/raster/arc_loop.h"
#include "texgen/raster/side_arc.h"

#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// The inset of a bubble of which every side shows: its sides' offsets, each cut off where it
/// crosses those of the sides beside it. Most bubbles are of that kind; `trace` says so only where
/// it is certain, by checks that cost little. What it finds has the bits of InsetTracer's.
class PlainInset {
  public:
    /// As of InsetTracer. Whether it is certain; if so, the loop was appended.
    bool trace(std::span<const SideArc> sides, double distance, ArcLoops& loops);

  private:
    static constexpr std::size_t kMostSides = 16;

    struct Offset {
        SideArc arc;
        double from = 0.0;  // parameters of what shows
        double to = 0.0;
        Vec2 tail{0.0, 0.0};
    };

    bool find_offsets(std::span<const SideArc> sides, double distance);
    bool find_crossings();
    bool keeps_distance(std::span<const SideArc> sides, double distance) const;

    std::size_t count_ = 0;
    std::array<Offset, kMostSides> offsets_;
};

}  // namespace foam::texgen
