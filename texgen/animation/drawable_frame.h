// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/raster/coords/raster_grid.h"

#include <optional>

namespace foam::texgen {

/// A frame of an animation on a raster grid, ready to be drawn: its layers and, in a cross-fade,
/// the layers of the state that fades in. Borrows the frame. The layers borrow the member `fade_`,
/// so a DrawableFrame cannot be copied or moved.
class DrawableFrame {
  public:
    /// `distance` has the same meaning as in FrameInput, and `threads` as in FrameLayers.
    DrawableFrame(const SimulatedFrame& frame,
                  const RasterGrid& grid,
                  const DistanceNeeds& distance,
                  int threads)
        : fade_(frame.cross_fade()),
          layers_{.layers = FrameLayers(frame.input(distance, fade()), grid, threads)} {
        if (fade_) {
            layers_.fading_in.emplace(frame.fading_in.input(distance, fade()), grid, threads);
        }
    }
    DrawableFrame(const DrawableFrame&) = delete;
    DrawableFrame& operator=(const DrawableFrame&) = delete;

    ShownLayers& layers() { return layers_; }
    const ShownLayers& layers() const { return layers_; }

  private:
    const CrossFade* fade() const { return fade_ ? &*fade_ : nullptr; }

    std::optional<CrossFade> fade_;
    ShownLayers layers_;
};

}  // namespace foam::texgen
