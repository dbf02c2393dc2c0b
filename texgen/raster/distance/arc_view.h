// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/arc_lanes.h"
#include "texgen/raster/distance/pixel_batch.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// The functions from which distances to arcs are computed, evaluated at a point, and bounds of the
/// distances. Eight arcs are computed at once.
class ArcView {
  public:
    /// Computes the functions and bounds of all arcs at a point. The members below refer to this
    /// point and these arcs.
    void evaluate(const ArcLanes& arcs, const Vec2& point);

    /// Returns a horizon: an arc that is farther from the point than the horizon is not the nearest
    /// arc of any pixel within `reach` of the point. The horizon is the distance to the nearest arc
    /// that the point faces, plus twice the reach and a margin.
    double horizon(double reach) const;
    /// Returns false if the arc k is certainly farther from the point than the horizon.
    bool is_within(std::size_t k, double horizon) const {
        return blocks_[k / kLanes].lower_bound[k % kLanes] <= horizon;
    }
    /// Return the functions of the arc k, relative to the point.
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
        Lanes lower_bound;  // a lower bound of the distance
        Lanes facing;       // the distance, or infinity if the point does not face the arc
    };

    static void evaluate(double x, double y, const ArcLanes::Block& arcs, Block& block);

    std::size_t size_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace foam::texgen
