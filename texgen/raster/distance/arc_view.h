// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/raster/distance/pixel_batch.h"
#include "texgen/raster/distance/region.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Computes the functions of position that determine distances from arcs (ArcFunctions and
/// FilmFunctions). Each function is stored as its value and gradient at one point; a quadratic
/// function also has a curvature. PixelBatch uses the functions to compute the distances between
/// the arcs and the pixels near this point. Also computes lower bounds of the distances between the
/// arcs and the point itself. Positions and distances are in pixels.
class ArcView {
  public:
    /// Computes the functions and bounds of all arcs at a point. The other members refer to this
    /// point and these arcs.
    void evaluate(std::span<const DistanceArc> arcs, const Vec2& point);

    /// Returns the horizon, a distance from the point. An arc beyond the horizon is not the nearest
    /// arc of any pixel within a distance of `reach` from the point. The horizon is the distance to
    /// the nearest arc that the point faces (see DistanceArc::kMinCosine), plus twice the reach and
    /// a margin. It is infinite if the point faces no arc.
    double horizon(double reach) const;
    /// Returns false only if the arc k is certainly farther from the point than the horizon.
    bool is_within(std::size_t k, double horizon) const {
        return blocks_[k / kLanes].lower_bound[k % kLanes] <= horizon;
    }
    /// Return the functions of the arc k. Their argument is a position relative to the point.
    ArcFunctions arc_functions(std::size_t k) const;
    FilmFunctions film_functions(std::size_t k) const;

  private:
    static constexpr std::size_t kLanes = 8;  // number of arcs that are processed at once
    using Lanes = KernelArray<double, kLanes>;
    using FloatLanes = KernelArray<float, kLanes>;

    struct ArcBlock {
        Lanes tail_x, tail_y, chord_x, chord_y, cosine, sine;
    };
    // The results for eight arcs.
    struct alignas(64) Block {
        FloatLanes twice_value, slope_x, slope_y, curvature;        // ArcFunctions::across
        FloatLanes tail, tail_x, tail_y, head, head_x, head_y;      // past_tail, before_head
        FloatLanes twice_along, along_x, along_y, along_curvature;  // FilmFunctions::along
        FloatLanes chord;                                           // FilmFunctions::chord
        Lanes lower_bound;  // a lower bound of the distance of the point from the arc
        Lanes facing;       // the distance, or infinity if the point does not face the arc
    };

    static void evaluate(double x, double y, const ArcBlock& arcs, Block& block);

    std::size_t size_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace foam::texgen
