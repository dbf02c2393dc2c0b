#pragma once

#include "texgen/raster/field_arc.h"
#include "texgen/raster/pixel_batch.h"

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
    std::size_t size() const { return chord_.size(); }

    /// Measures a batch of which no pixel is farther from its middle than `reach`; leaves out the
    /// sides that are too far to matter.
    void measure(double reach, bool gradient, PixelBatch& batch);

  private:
    // The functions of all sides at a point, and how far each side is from there at least.
    void look_from(const Vec2& point);
    // No side farther than this is nearest to a point within reach.
    double horizon(double reach) const;
    FloatQuadratic across(std::size_t k) const;
    FloatLine tail_line(std::size_t k) const;
    FloatLine head_line(std::size_t k) const;
    Vec2 end(std::size_t k, double sign) const;  // -1 for the tail, 1 for the head
    void add_corners(double farthest, bool all, PixelBatch& batch) const;

    using Doubles = std::vector<double>;

    // Of each side.
    Doubles middle_x_, middle_y_, direction_x_, direction_y_;
    Doubles chord_, over_chord_, cosine_, sine_;
    std::vector<bool> corner_;
    bool any_corner_ = false;

    // At the point that was looked from; lines are normal to the arc at its ends.
    Doubles twice_, slope_x_, slope_y_, past_tail_, before_head_, at_least_, facing_;
};

}  // namespace foam::texgen
