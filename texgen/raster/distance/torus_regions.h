// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/distance/region.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace foam::texgen {

/// The bubbles of a frame on a torus, in the coordinates of the unshifted grid. Borrows the frame.
///
/// A bubble begins at the tail of its first side. Bubbles are sorted by the square of the grid in
/// which they begin. Squares are numbered from left to right, in rows from bottom to top.
class TorusRegions {
  public:
    static constexpr int kSquare = 32;             // side of a square, pixels
    static constexpr std::size_t kGroupSize = 16;  // bubbles that are traced at once

    /// The start of a counter-clockwise traversal of the sides of a bubble.
    struct Start {
        std::uint32_t bubble = 0;
        HalfEdgeId side{};    // the first side
        SubpixelPoint from;   // the tail of the first side
        Vec2 tail{0.0, 0.0};  // the same point without rounding, in pixels
    };

    TorusRegions(const Frame& frame, const RasterGrid& grid, int threads);

    /// Returns the starts of the bubbles that begin in the pixel rows [first, first + rows).
    /// Precondition: `first` and `rows` are multiples of kSquare.
    std::span<const Start> starts(int first, int rows) const;

    /// Traces the boundaries of up to kGroupSize bubbles. Region k becomes the region of the bubble
    /// of start k. The bubbles are traced in lockstep, so that their cache misses overlap: the next
    /// film of a bubble is known only after the current film has been read from memory.
    /// Precondition: there are at least as many regions as starts.
    void trace(std::span<const Start> starts, std::span<Region> regions) const;

    /// Returns the shear in subpixels: the copy of a point that is one period higher is also moved
    /// to the right by this distance.
    std::int32_t shear() const { return pixels_.shear; }

  private:
    // The data of a film that the boundaries on both its sides need, in one cache line. Each array
    // has the value of the forward side first, then the value of its twin.
    struct alignas(64) Film {
        double chord_x, chord_y;  // of the forward side, pixels
        double cosine, sine;      // of half the angle by which the forward side turns left
        std::array<std::int32_t, 2> tail_x, tail_y;  // in the fundamental cell, subpixels
        std::array<HalfEdgeId, 2> next;              // the next side around the bubble
        std::int32_t offset_x, offset_y;  // the film's lattice offset as a translation, subpixels
    };
    static_assert(sizeof(Film) == 64);

    // The state of the traversal of one bubble.
    struct Traversal {
        HalfEdgeId side{};    // the next side to add to the boundary
        HalfEdgeId first{};   // the side at which the traversal began
        Vec2 tail{0.0, 0.0};  // unwrapped position of the tail of `side`, pixels
        // The translation from the tail in the fundamental cell to its unwrapped position,
        // subpixels.
        SubpixelPoint unwrapping;
        Boundary* boundary = nullptr;
    };

    std::unique_ptr<Film[]> films(int threads) const;
    Buckets<Start> sorted_starts(int threads) const;
    void advance(Traversal& traversal) const;

    PixelFrame pixels_;
    std::size_t columns_;  // number of columns of squares
    std::vector<SubpixelPoint> junctions_;
    std::unique_ptr<Film[]> films_;  // indexed by film
    Buckets<Start> starts_;          // one bucket per square
};

}  // namespace foam::texgen
