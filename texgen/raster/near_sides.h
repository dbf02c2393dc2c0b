#pragma once

#include "texgen/raster/field_arc.h"
#include "texgen/raster/pixel_batch.h"

#include <array>
#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A side of a region, which lies on its left.
struct RegionSide {
    FieldArc arc;         // turns by no more than 120 degrees
    bool corner = false;  // at its tail the region has more than 180 degrees
};

/// A few sides of a region, laid out so that what they are to a batch of pixels is found for
/// several of them at once.
class NearSides {
  public:
    void clear();
    void add(const RegionSide& side);
    std::size_t size() const { return size_; }

    /// Measures a batch of which no pixel is farther from its middle than `reach`; leaves out the
    /// sides that are too far to matter.
    void measure(double reach, bool gradient, PixelBatch& batch);

  private:
    static constexpr std::size_t kLanes = 8;
    using Lanes = std::array<double, kLanes>;

    // Some sides, as loops over them like it; those beyond the last are all 0.
    struct Block {
        Lanes middle_x, middle_y, direction_x, direction_y;
        Lanes chord, over_chord, cosine, sine;
        // At the point that was looked from; lines are normal to the arc at its ends.
        Lanes twice, slope_x, slope_y, past_tail, before_head, at_least, facing;
    };

    void set(std::size_t k, const FieldArc& arc, double over_chord);
    static void look_from(const Vec2& point, Block& block);
    // The functions of all sides at a point, and how far each side is from there at least.
    void look_from(const Vec2& point);
    // No side farther than this is nearest to a point within reach.
    double horizon(double reach) const;
    double at(Lanes Block::*column, std::size_t k) const {
        return (blocks_[k / kLanes].*column)[k % kLanes];
    }
    FloatQuadratic across(std::size_t k) const;
    FloatLine tail_line(std::size_t k) const;
    FloatLine head_line(std::size_t k) const;
    Vec2 end(std::size_t k, double sign) const;  // -1 for the tail, 1 for the head
    void add_corners(double farthest, bool all, PixelBatch& batch) const;

    std::size_t size_ = 0;
    std::vector<Block> blocks_;
    std::vector<std::size_t> corners_;
};

}  // namespace foam::texgen
