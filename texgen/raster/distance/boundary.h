// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/distance/arc_lanes.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// A box around a region, in subpixels: its lower left and its upper right corner.
struct Extent {
    Vec2 lowest{0.0, 0.0};
    Vec2 highest{0.0, 0.0};
};

/// The boundary of a region: closed loops of arcs with the region on their left.
///
/// The boundary is stored in two forms. Distances are measured from the exact arcs, in pixels. Ids
/// are decided by an outline, whose arcs or straight edges end at whole subpixels. Two neighboring
/// regions round the ends of a shared arc to the same subpixels, so that no pixel between them is
/// left out or counted twice.
class Boundary {
  public:
    /// Eight arcs of an outline, in subpixels. Lanes beyond the last arc have no length.
    struct alignas(64) Outline {
        ArcLanes::Lanes<double> from_x, from_y, to_x, to_y;
        ArcLanes::Lanes<double> cosine, sine;  // of half the angle by which an arc turns left
    };

    /// Removes all arcs, and keeps the memory.
    void clear();

    /// Adds an exact arc that begins at `tail`, in pixels. An arc whose chord is at most
    /// kShortestSide is ignored. Precondition: the tail is the head of the preceding arc of the
    /// loop.
    void add_arc(const PixelArc& shape, const Vec2& tail);
    /// Ends a loop of exact arcs. The next exact arc begins a new loop.
    void close_loop();

    /// Adds an arc or a straight edge to the outline. `from` and `to` are whole numbers of
    /// subpixels; `cosine` and `sine` are the cosine and the sine of half the angle by which the
    /// arc turns left.
    void add_edge(const Vec2& from, const Vec2& to, double cosine, double sine);

    /// Returns a box that encloses the outline. It is the smallest box around the ends of all arcs,
    /// enlarged by an upper bound of the largest distance of an arc from its chord and by a margin
    /// for rounding errors.
    /// Precondition: the outline is not empty.
    Extent extent() const;

    /// Returns the exact arcs for measuring distances. Arcs wider than ArcLanes::kMinCosine allows
    /// are halved until they fit.
    const ArcLanes& arcs() const { return arcs_; }
    /// Returns the exact arcs without halving: one per film.
    const ArcLanes& films() const { return has_wide_ ? films_ : arcs_; }
    /// Returns the outline in blocks of eight arcs.
    std::span<const Outline> outline() const {
        return std::span(outline_).first((edges_ + ArcLanes::kLanes - 1) / ArcLanes::kLanes);
    }

  private:
    void add_wide(const PixelArc& shape, const Vec2& tail, bool corner);
    void add_halves(const PixelArc& shape, const Vec2& tail, bool corner);

    ArcLanes arcs_;
    // The arcs without halving. Unused unless has_wide_ is true, because it would equal arcs_.
    ArcLanes films_;
    bool has_wide_ = false;        // true if an arc has been halved
    std::size_t loop_ = 0;         // index of the first arc of the current loop
    Vec2 loop_tangent_{0.0, 0.0};  // tangent at the start of the current loop
    Vec2 head_tangent_{0.0, 0.0};  // tangent at the end of the last arc
    std::size_t edges_ = 0;        // number of arcs of the outline
    std::vector<Outline> outline_;
};

/// Returns the two halves of an arc, the half at its tail first.
std::array<PixelArc, 2> halves(const PixelArc& arc);

inline void Boundary::add_arc(const PixelArc& shape, const Vec2& tail) {
    if (!(shape.chord.squaredNorm() > kShortestSide * kShortestSide)) {
        return;
    }
    const Vec2 tangent = tail_tangent(shape);
    const bool is_first = arcs_.size() == loop_;
    if (is_first) {
        loop_tangent_ = tangent;
    }
    const bool corner = !is_first && cross(head_tangent_, tangent) < 0.0;
    head_tangent_ = head_tangent(shape);
    if (has_wide_ || shape.cosine < ArcLanes::kMinCosine) [[unlikely]] {
        add_wide(shape, tail, corner);
    } else {
        arcs_.add(shape, tail, corner);
    }
}

inline void Boundary::add_edge(const Vec2& from, const Vec2& to, double cosine, double sine) {
    const std::size_t k = edges_ % ArcLanes::kLanes;
    const std::size_t block = edges_ / ArcLanes::kLanes;
    if (block == outline_.size()) {
        outline_.emplace_back();
    }
    if (k == 0) {
        outline_[block].from_x.fill(from.x());
        outline_[block].from_y.fill(from.y());
        outline_[block].to_x.fill(from.x());
        outline_[block].to_y.fill(from.y());
    }
    Outline& to_block = outline_[block];
    to_block.from_x[k] = from.x();
    to_block.from_y[k] = from.y();
    to_block.to_x[k] = to.x();
    to_block.to_y[k] = to.y();
    to_block.cosine[k] = cosine;
    to_block.sine[k] = sine;
    ++edges_;
}

}  // namespace foam::texgen
