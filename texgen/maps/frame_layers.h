// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/arc_distance.h"
#include "texgen/maps/fade_border.h"
#include "texgen/maps/foam_record.h"
#include "texgen/maps/frame_one.h"
#include "texgen/maps/grain.h"
#include "texgen/maps/maze_graph.h"
#include "texgen/raster/distance/distance_field.h"
#include "texgen/raster/outline/cell_arcs.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace foam::texgen {

/// A frame, and everything else that maps need to draw it. Borrows the frames, the record and the
/// cross-fade.
struct FrameInput {
    const Frame& frame;
    const FoamRecord& record;
    const Frame* next = nullptr;  // the frame after `frame`; null if no map needs it
    /// The images of the distance field that maps need, apart from ids.
    DistanceNeeds distance{};
    /// The cross-fade to which `frame` belongs; null if images show only one foam. Precondition:
    /// `frame` refers to CrossFade::fading_out or CrossFade::fading_in itself, not to a copy.
    const CrossFade* fade = nullptr;
    const FrameOne* first = nullptr;  // frame 1 of the animation; null if it is not known
};

/// A frame on a raster grid, and the intermediate results that its maps share. Each result is
/// computed when a map first needs it, and then kept. The class is not thread-safe: only one thread
/// at a time may use an object.
class FrameLayers {
  public:
    /// `threads` is the number of threads that draw this one frame.
    FrameLayers(const FrameInput& input, const RasterGrid& grid, int threads);

    const Frame& frame() const { return input_.frame; }
    const FoamRecord& record() const { return input_.record; }
    /// Returns the next frame. Throws std::invalid_argument if there is none.
    const Frame& next() const;
    /// Returns frame 1 of the animation, or nullptr if it is not known.
    const FrameOne* first() const { return input_.first; }
    const RasterGrid& grid() const { return grid_; }
    int threads() const { return threads_; }
    bool is_patch() const { return frame().domain.is_plane(); }

    /// Returns the outlines of the visible parts of bubbles (cell_arcs) for a film width in pixels.
    /// Throws as cell_arcs does.
    const CellArcs& arcs(double film_width);
    /// Returns the distance field of the frame. It contains the ids and the images that
    /// FrameInput::distance selects. In a cross-fade, the distance at a pixel is measured from
    /// the films of the foam that the pixel shows. If the border between the two foams is nearer,
    /// the distance is measured from the border (join_at_border). The field then also contains the
    /// smooth distance and its gradient.
    const DistanceField& distance();
    /// Returns the border between the two foams; nullptr without a cross-fade.
    const FadeBorder* border();
    /// Returns the layers of the same frame on another grid, which shows the same tile or view.
    /// Maps that need the next frame cannot be drawn from the result. `distance` replaces
    /// FrameInput::distance.
    FrameLayers on_grid(const RasterGrid& grid, const DistanceNeeds& distance) const;
    /// Returns the maze of the frame (find_maze).
    const Maze& maze(const MazeRule& rule);
    /// Returns the distances to the walls of the maze and to the circles of lone bubbles
    /// (distances_to_arcs). Throws std::invalid_argument if the grid does not fit the domain, for
    /// example if pixels on a torus are not square (pixels_per_unit).
    const ArcDistances& wall_distances(const MazeRule& rule, const ArcDistanceNeeds& needs);
    /// Returns a grain (draw_grain). Only a grain for the relief has slopes, and only if
    /// FrameInput::distance selects the gradient of the smooth distance: the slopes of a relief
    /// need both. Throws std::invalid_argument if the grid does not fit the domain
    /// (diameters_in_pixels).
    const Grain& grain(const GrainRule& rule);
    /// Returns the id of the surroundings of a patch in DistanceField::ids. On a torus, no pixel
    /// has this id.
    std::uint32_t surroundings_id() const {
        return static_cast<std::uint32_t>(frame().bubbles.size());
    }
    /// Returns true if `id`, a sample of DistanceField::ids, denotes the surroundings of a patch.
    bool is_surroundings(std::uint32_t id) const { return is_patch() && id == surroundings_id(); }

  private:
    void join_fields();

    FrameInput input_;
    RasterGrid grid_;
    int threads_;
    std::map<double, CellArcs> arcs_;  // the key is the film width
    std::optional<DistanceField> distance_;
    std::optional<FadeBorder> border_;
    std::map<MazeRule, Maze> mazes_;
    std::map<GrainRule, Grain> grains_;
    std::map<std::pair<MazeRule, ArcDistanceNeeds>, ArcDistances> wall_distances_;
};

}  // namespace foam::texgen
