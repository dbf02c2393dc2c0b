#pragma once

#include "texgen/raster/bands.h"
#include "texgen/raster/pixel_frame.h"
#include "texgen/raster/region_field.h"
#include "texgen/raster/row_crossings.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// The bubbles of a frame on a torus, laid out so that each is quickly placed. Borrows the frame.
class TorusCells {
  public:
    /// The same for any number of threads. Throws std::invalid_argument as pixels_per_unit does.
    TorusCells(const Frame& frame, const RasterGrid& grid, int threads);

    TorusCells(const TorusCells&) = delete;
    TorusCells& operator=(const TorusCells&) = delete;

    std::int32_t shear() const { return pixels_.shear; }
    /// The bubbles in an order in which those near to each other mostly lie near in memory, too.
    std::span<const BubbleId> bubbles() const { return bubbles_; }
    /// Of each of them; somewhat too large. Begins with the tail of its first side.
    std::span<const RegionExtent> extents() const { return extents_; }

    /// Where a bubble is drawn.
    struct Place {
        SubpixelPoint translation;  // of the bubble
        SubpixelPoint corner;       // of the pixel that the region is relative to
        SubpixelPoint mask;         // the same of the mask
    };
    /// Marks the boundary of a bubble, by its place among them, in a mask, which is empty, and
    /// makes it the region.
    void place(std::size_t bubble,
               const Place& at,
               RowCrossings& crossings,
               CellMask& mask,
               RegionField& region) const;

  private:
    // Of a bubble, as one goes around it.
    struct Side {
        FilmArc arc;         // pixels
        SubpixelPoint tail;  // of the unwrapped bubble
    };
    // The bubbles of a task.
    struct Batch {
        std::vector<Side> sides;
        std::vector<std::size_t> ends;  // one past the last side of each
    };

    static constexpr std::size_t kPerTask = 1024;
    static constexpr std::size_t kAhead = 16;       // bubbles, a part of a task
    static constexpr std::size_t kMostlySides = 7;  // no more than these of a bubble, mostly

    // The offsets of the first sides of some bubbles, by their places; goes on around bubbles that
    // have fewer.
    using Ahead = std::array<std::array<LatticeOffset, kAhead>, kMostlySides>;

    void order_bubbles();
    void gather_bubbles(int task);
    Ahead look_ahead(std::size_t begin, std::size_t end) const;
    void gather(std::size_t place, const Ahead& ahead, Batch& batch);
    std::span<const Side> sides_of(std::size_t place) const;

    RasterGrid grid_;
    PixelFrame pixels_;
    std::vector<SubpixelPoint> junctions_;
    std::vector<BubbleId> bubbles_;
    std::vector<RegionExtent> extents_;
    std::vector<Vec2> firsts_;  // the tails of their first sides without rounding; pixels
    std::vector<Batch> batches_;
};

}  // namespace foam::texgen
