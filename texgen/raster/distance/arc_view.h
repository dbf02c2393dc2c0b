#pragma once

#include "texgen/raster/distance/arc_lanes.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Arcs as a point sees them: the functions that their distances are made of, and bounds of the
/// distances. Eight arcs are computed at once.
class ArcView {
  public:
    /// Computes the functions and bounds of all arcs at a point. The members below refer to it.
    void evaluate(const ArcLanes& arcs, const Vec2& point);

    /// Returns an upper bound of the distance between any point within reach of the point and its
    /// nearest arc, plus reach: farther arcs are not nearest to any such point.
    double horizon(double reach) const;
    bool is_within(std::size_t k, double horizon) const {
        return blocks_[k / kLanes].at_least[k % kLanes] <= horizon;
    }
    ArcFunctions functions(std::size_t k) const;
    FilmFunctions film_functions(std::size_t k) const;

  private:
    static constexpr std::size_t kLanes = ArcLanes::kLanes;
    using Lanes = ArcLanes::Lanes<double>;

    using FloatLanes = ArcLanes::Lanes<float>;

    // The results for eight arcs.
    struct alignas(64) Block {
        FloatLanes twice, slope_x, slope_y, curvature;
        FloatLanes tail, tail_x, tail_y, head, head_x, head_y;
        FloatLanes twice_along, along_x, along_y, along_curvature, chord;
        Lanes at_least;
        Lanes facing;  // the distance, infinite if the point does not face the arc
    };

    static void evaluate(double x, double y, const ArcLanes::Block& arcs, Block& block);

    std::size_t size_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace foam::texgen
