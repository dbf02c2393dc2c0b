// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/counting_sort.h"
#include "core/parallel/kernel_array.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/distance/region.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The bubbles of a frame on a torus, in the coordinates of the unshifted grid. Borrows the frame.
///
/// The grid is divided into squares of kSquare x kSquare pixels, which are numbered row by row.
/// Bubbles are sorted by the square in which their first side begins, and films by the square that
/// contains their tail (README.md tells why).
class TorusRegions {
  public:
    static constexpr int kSquare = 32;  // side of a square, pixels

    /// The start of a counter-clockwise traversal of the sides of a bubble.
    struct Start {
        std::uint32_t bubble = 0;
        std::uint32_t side = 0;  // the first side (Side, below)
        SubpixelPoint from;      // the tail of the first side
        Vec2 tail{0.0, 0.0};     // the same point without rounding, in pixels
    };

    /// Throws std::invalid_argument if the grid is too large or empty, or if it does not fit the
    /// domain (pixels_per_unit).
    TorusRegions(const Frame& frame, const RasterGrid& grid, int threads);

    /// Returns the starts of the bubbles that begin in the pixel rows [first, first + rows).
    /// Precondition: `first` and `rows` are multiples of kSquare.
    std::span<const Start> starts(int first, int rows) const;

    /// Traces the boundary of a bubble. `region` becomes the region of the bubble; its memory is
    /// reused.
    void trace(const Start& start, Region& region) const;

    /// Returns the shear in subpixels: the copy of a point one period above it is also moved to the
    /// right by this distance.
    std::int32_t shear() const { return pixels_.shear; }

  private:
    // A half-edge: twice the index of its film in films_, plus 1 if it is the twin of the forward
    // side.
    using Side = std::uint32_t;
    // The data of a film that the boundaries on both its sides need, in one cache line. Each array
    // has the value of the forward side first, then the value of its twin.
    struct alignas(64) Film {
        PixelArc arc;                        // the arc of the forward side
        KernelArray<SubpixelPoint, 2> tail;  // tails in the fundamental cell
        KernelArray<Side, 2> next;           // the next side around the bubble
        SubpixelPoint offset;                // lattice offset of the forward side as a translation
    };
    static_assert(sizeof(Film) == 64);

    template <class Item, class PositionOf>
    Buckets<Item> sorted(std::span<const Item> items,
                         int threads,
                         const PositionOf& position) const;
    std::vector<Film> sorted_films(int threads);
    Buckets<Start> sorted_starts(int threads) const;
    Side side_of(HalfEdgeId h) const {
        return 2 * new_index_[index_of(film_of(h))] + static_cast<Side>(index_of(h) % 2);
    }

    PixelFrame pixels_;
    std::size_t columns_;                   // number of columns of squares
    std::vector<std::uint32_t> new_index_;  // the position of each film in films_
    std::vector<Film> films_;  // followed by unused films (kFilmsAhead in torus_regions.cpp)
    Buckets<Start> starts_;    // one bucket per square
};

}  // namespace foam::texgen
