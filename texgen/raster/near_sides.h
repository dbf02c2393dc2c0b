#pragma once

#include "texgen/raster/field_arc.h"
#include "texgen/raster/pixel_batch.h"
#include "texgen/raster/side_lanes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Of half the angle that a side of a region turns, at least.
inline constexpr double kLeastSideCosine = 0.5;

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
    /// All sides of a bubble at once, in place of these, as a region's are taken; `first` is the
    /// tail of the first one, in pixels. Whether they could be: not if there are more than kLanes,
    /// or if one has no direction or is to be halved.
    bool take(const BubbleSides& sides, const Vec2& first);

    std::size_t size() const { return size_; }
    FieldArc arc(std::size_t k) const;

    /// Measures a batch of which no pixel is farther from its middle than `reach`; leaves out the
    /// sides that are too far to matter.
    void measure(double reach, bool gradient, PixelBatch& batch);

  private:
    static constexpr std::size_t kLanes = SideLanes::kLanes;
    using Lanes = SideLanes::Lanes<double>;
    using FloatLanes = SideLanes::Lanes<float>;

    // Some sides, as loops over them like it; those beyond the last are all 0.
    struct alignas(64) Block {
        Lanes middle_x, middle_y, direction_x, direction_y;
        Lanes chord, over_chord, cosine, sine;
        // At the point that was looked from; lines are normal to the arc at its ends.
        Lanes twice, slope_x, slope_y, past_tail, before_head, at_least, facing;
        FloatLanes twice_float, slope_x_float, slope_y_float, curvature_float;
        FloatLanes tail_float, tail_x_float, tail_y_float, head_float, head_x_float, head_y_float;
    };

    void set(std::size_t k, const FieldArc& arc, double over_chord);
    static bool place(const SideLanes& sides, std::size_t count, const Vec2& first, Block& block);
    static bool find_corners(const Block& block, std::size_t count, Lanes& turns);
    static void look_from(const Vec2& point, Block& block);
    // The functions of all sides at a point, and how far each side is from there at least.
    void look_from(const Vec2& point);
    // No side farther than this is nearest to a point within reach.
    double horizon(double reach) const;
    double at(Lanes Block::*column, std::size_t k) const {
        return (blocks_[k / kLanes].*column)[k % kLanes];
    }
    FloatArc in_floats(std::size_t k) const;
    Vec2 end(std::size_t k, double sign) const;  // -1 for the tail, 1 for the head
    void add_corners(double farthest, bool all, PixelBatch& batch) const;

    std::size_t size_ = 0;
    std::vector<Block> blocks_;
    std::vector<std::size_t> corners_;
    std::vector<FloatArc> near_;
};

}  // namespace foam::texgen
