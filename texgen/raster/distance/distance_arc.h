#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// A side of a region: an arc with the region on its left. Positions are relative to the lower left
/// corner of a pixel.
///
/// The arc exists twice: distances are measured from its exact position; ids are decided by the arc
/// of the same angle between ends that are rounded to subpixels, which neighbors round alike.
struct DistanceArc {
    PixelArc shape;
    Vec2 tail{0.0, 0.0};  // pixels
    Vec2 from{0.0, 0.0};  // the rounded tail, in whole subpixels
    Vec2 to{0.0, 0.0};    // the rounded head
};

/// A straight line between two points in whole subpixels.
struct Edge {
    Vec2 from{0.0, 0.0};
    Vec2 to{0.0, 0.0};
};

/// The boundary of a region: closed loops of sides, each side beginning where the last one ends.
struct Boundary {
    std::vector<DistanceArc> sides;
    std::vector<std::size_t> loop_ends;  // one past the last side of each loop
    std::vector<Edge> edges;             // decide ids in place of the sides, if there are any

    void clear();
    void close_loop() { loop_ends.push_back(sides.size()); }
    std::span<const DistanceArc> loop(std::size_t k) const;
};

/// A box around a region, in subpixels.
struct Extent {
    Vec2 lowest{0.0, 0.0};
    Vec2 highest{0.0, 0.0};
};

/// Returns a box that encloses a boundary and is larger by up to the sagitta of a side.
/// Precondition: there is a side.
Extent extent_of(const Boundary& boundary);

/// Returns the two halves of an arc, which have equal length.
std::array<PixelArc, 2> halves(const PixelArc& arc);

}  // namespace foam::texgen
