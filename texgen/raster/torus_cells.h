#pragma once

#include "texgen/raster/bands.h"
#include "texgen/raster/pixel_frame.h"
#include "texgen/raster/side_lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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

    /// By the bubble's place among them.
    BubbleSides sides(std::size_t bubble) const;
    /// Has the memory fetched that sides() will be read from.
    void expect(std::size_t bubble) const;

  private:
    // The bubbles of a task.
    struct Batch {
        struct Bubble {
            std::uint32_t first_lanes;
            std::uint32_t sides;
        };
        std::unique_ptr<SideLanes[]> lanes;
        std::vector<Bubble> bubbles;
    };

    // Around a bubble.
    struct Walk {
        HalfEdgeId side{};
        LatticeOffset lift;
        SideLanes* to = nullptr;
        std::size_t sides = 0;
    };

    static constexpr std::size_t kPerTask = 1024;
    static constexpr std::size_t kTogether = 16;  // bubbles, a part of a task

    void order_bubbles();
    void gather_bubbles(int task);
    void gather(std::size_t begin, std::size_t end, Batch& batch);
    void go(std::size_t step, Walk& walk) const;

    RasterGrid grid_;
    PixelFrame pixels_;
    std::vector<PixelArc> shapes_;  // of films
    std::vector<SubpixelPoint> junctions_;
    std::vector<BubbleId> bubbles_;
    std::vector<RegionExtent> extents_;
    std::vector<Vec2> firsts_;  // the tails of their first sides without rounding; pixels
    std::vector<Batch> batches_;
};

}  // namespace foam::texgen
