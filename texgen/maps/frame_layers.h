// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/foam_record.h"
#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <map>
#include <optional>

namespace foam::texgen {

/// A frame, and everything else that maps need to draw it. Both frames and the record are borrowed.
struct FrameInput {
    const Frame& frame;
    const FoamRecord& record;
    const Frame* next = nullptr;  // the frame after `frame`, for maps that need it
    DistanceNeeds distance{};     // the union of the needs of all maps
};

/// A frame on a raster grid, and the intermediate results that its maps share. Each result is
/// computed when a map first needs it, and then kept. Not thread-safe: one thread may use an object
/// at a time.
class FrameLayers {
  public:
    /// `threads` is the number of threads that draw this one frame.
    FrameLayers(const FrameInput& input, const RasterGrid& grid, int threads);

    const Frame& frame() const { return input_.frame; }
    const FoamRecord& record() const { return input_.record; }
    /// Returns the next frame. Throws std::invalid_argument if there is none.
    const Frame& next() const;
    const RasterGrid& grid() const { return grid_; }
    int threads() const { return threads_; }
    bool is_patch() const { return frame().domain.is_plane(); }

    /// Returns the outlines of cells and films for a film width in pixels. Throws as cell_arcs
    /// does.
    const CellArcs& arcs(double film_width);
    /// Returns the distances to films, with the images named in FrameInput::distance.
    const DistanceField& distance();
    /// Returns true if an id of the distance field stands for the surroundings of a patch.
    bool is_around(std::uint32_t id) const { return is_patch() && id == frame().bubbles.size(); }

  private:
    FrameInput input_;
    RasterGrid grid_;
    int threads_;
    std::map<double, CellArcs> arcs_;  // the key is the film width
    std::optional<DistanceField> distance_;
};

}  // namespace foam::texgen
