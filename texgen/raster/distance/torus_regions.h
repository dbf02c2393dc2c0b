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

/// The bubbles of a frame on a torus, in the coordinates of a grid. Borrows the frame.
///
/// Bubbles are sorted by the square of the unshifted grid in which they begin, row by row.
class TorusRegions {
  public:
    static constexpr int kSquare = 32;             // pixels
    static constexpr std::size_t kGroupSize = 16;  // bubbles that are traced at once

    /// The start of a counter-clockwise traversal of a bubble.
    struct Start {
        std::uint32_t bubble = 0;
        HalfEdgeId side{};
        SubpixelPoint from;
        Vec2 tail{0.0, 0.0};  // the same point without rounding, in pixels
    };

    TorusRegions(const Frame& frame, const RasterGrid& grid, int threads);

    /// Returns the bubbles that begin in `rows` rows from `first` on, both multiples of kSquare.
    std::span<const Start> starts(int first, int rows) const;

    /// Traces up to kGroupSize bubbles in lockstep, so that their cache misses overlap. The next
    /// film of a bubble is known only after the current film has been read from memory.
    void trace(std::span<const Start> starts, std::span<Region> regions) const;

    /// Returns the distance in subpixels by which a copy one period up is moved to the right.
    std::int32_t shear() const { return pixels_.shear; }

  private:
    // The data of a film that the boundaries on both its sides need, in one cache line. Each pair
    // has the value of the forward side first, then the value of its twin.
    struct alignas(64) Film {
        double chord_x, chord_y;  // of the forward side, pixels
        double cosine, sine;      // of half the angle by which the forward side turns left
        std::array<std::int32_t, 2> tail_x, tail_y;  // subpixels
        std::array<HalfEdgeId, 2> next;
        std::int32_t lift_x, lift_y;  // translation of the head by the film's lattice offset
    };
    static_assert(sizeof(Film) == 64);

    struct Traversal {
        HalfEdgeId side{};
        HalfEdgeId first{};
        Vec2 tail{0.0, 0.0};
        SubpixelPoint lift;
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
