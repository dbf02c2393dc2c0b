// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/fixed_point.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// An arc from which distances are measured, in pixels.
struct DistanceArc {
    /// The smallest cosine of the half angle of an arc whose distance is measured: the arc turns by
    /// at most 120 degrees. The function add_narrow_arcs cuts wider arcs in half until they fit. A
    /// point faces an arc if it is between the normals at both ends of the arc. This is tested with
    /// two half-planes, and the test fails for arcs that turn by more than 180 degrees.
    static constexpr double kMinCosine = 0.5;

    Vec2 tail{0.0, 0.0};
    PixelArc shape;
    /// True if the region on the left has an inner angle of more than 180 degrees at the tail, or
    /// if the tail is a free end, at which no other arc ends. The tail itself may then be the
    /// nearest point.
    bool corner = false;

    Vec2 head() const { return tail + shape.chord; }
};

/// An arc or a straight edge of the outline that decides which pixels get the id of a region. The
/// coordinates of its ends are whole numbers of subpixels. `cosine` and `sine` are the cosine and
/// the sine of half the angle by which the arc turns left; for an edge, this angle is 0.
struct OutlineArc {
    Vec2 from{0.0, 0.0};
    Vec2 to{0.0, 0.0};
    double cosine = 1.0;
    double sine = 0.0;
};

/// A box around a region, in subpixels: its lower left and its upper right corner.
struct Extent {
    Vec2 lowest{0.0, 0.0};
    Vec2 highest{0.0, 0.0};
};

/// The boundary of a region: closed loops of arcs with the region on their left. Distances are
/// measured from the exact arcs. Ids are decided by an outline, whose arcs end at whole subpixels.
/// Two neighboring regions round the ends of a shared arc to the same subpixels, so that no pixel
/// between them is left out or counted twice.
class Boundary {
  public:
    /// Removes all arcs, and keeps the memory.
    void clear();

    /// Adds an exact arc that begins at `tail`, in pixels. An arc whose chord is at most
    /// kShortestChord is ignored. Precondition: the tail is the head of the preceding arc of the
    /// loop.
    void add_arc(const PixelArc& shape, const Vec2& tail);
    /// Ends a loop of exact arcs. The next exact arc begins a new loop.
    void close_loop();
    /// Adds an arc to the outline.
    void add_edge(const OutlineArc& edge) { outline_.push_back(edge); }

    /// Returns a box that encloses the outline, with a margin for rounding errors. Precondition:
    /// the outline is not empty.
    Extent extent() const;

    /// Returns the exact arcs for measuring distances. Arcs that turn by more than 120 degrees are
    /// cut in halves (DistanceArc::kMinCosine).
    std::span<const DistanceArc> arcs() const { return arcs_; }
    /// Returns the exact arcs without halving: one per film, or two for the circle of a lone
    /// bubble. DistanceArc::corner may be wrong here; arcs() has the right values.
    std::span<const DistanceArc> films() const { return films_.empty() ? arcs_ : films_; }
    std::span<const OutlineArc> outline() const { return outline_; }

  private:
    std::vector<DistanceArc> arcs_;
    std::vector<DistanceArc> films_;  // empty if no arc was cut in halves; then arcs_ are the films
    std::vector<OutlineArc> outline_;
    std::size_t loop_ = 0;         // index in arcs_ of the first arc of the current loop
    Vec2 loop_tangent_{0.0, 0.0};  // tangent at the start of the current loop
    Vec2 head_tangent_{0.0, 0.0};  // tangent at the end of the last arc
};

/// Returns the two halves of an arc, the half at its tail first.
std::array<PixelArc, 2> halves(const PixelArc& arc);

/// Appends an arc to `arcs`. An arc that turns by more than 120 degrees is cut in halves until the
/// parts fit (DistanceArc::kMinCosine).
void add_narrow_arcs(const DistanceArc& arc, std::vector<DistanceArc>& arcs);

enum class RegionKind {
    Bubble,
    Circle,        // a lone bubble; its boundary is a circle of two arcs
    Surroundings,  // the ghost bubble: the space around a patch and in its holes, unbounded
};

/// A region of the plane whose pixels have the same id. Positions are in the coordinates of the
/// unshifted grid. On a torus the region is unwrapped: it may extend beyond the grid by several
/// periods.
struct Region {
    std::uint32_t id = 0;  // the value of the region's pixels in DistanceField::ids
    RegionKind kind = RegionKind::Bubble;
    bool is_chain = false;  // true if all edges of the outline are straight
    SubpixelPoint first;    // the tail of the first side of the bubble; set on a torus only
    // The lower left and the upper right corner of a box around the region. In a patch, the box is
    // clipped to the image.
    SubpixelPoint lowest;
    SubpixelPoint highest;
    Boundary boundary;
};

/// The rows of pixels [begin, end).
struct PixelRows {
    int begin = 0;
    int end = 0;
};

/// A rectangle of pixels. `right` and `top` are one past the last column and row.
struct PixelBox {
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;

    int columns() const { return right - left; }
    int rows() const { return top - bottom; }
};

/// Returns a box that contains all pixels of a region that is moved by a translation.
inline PixelBox box_around(const Region& region, SubpixelPoint translation) {
    const SubpixelPoint low = region.lowest + translation;
    const SubpixelPoint high = region.highest + translation;
    return {pixel_of(low.x), pixel_of(high.x) + 1, pixel_of(low.y), pixel_of(high.y) + 1};
}

}  // namespace foam::texgen
