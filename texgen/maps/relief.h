// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/grain.h"
#include "texgen/maps/maze.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/relief_section.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foam::texgen {

/// The options of a relief. Borrows them.
struct ReliefSource {
    const ReliefOptions& relief;
    const MazeOptions& maze;  // used only if the walls of a maze shape the relief
};

/// The relief of a frame: a surface whose height varies over the foam, at the centers of pixels.
/// Heights come from the smooth distance (DistanceField::smooth), which has no creases within a
/// bubble, and slopes come from its gradient. There are therefore creases only along films. A grain
/// (grain.h), which fades out towards films, is added if ReliefOptions::grain is above 0. With the
/// profiles Ridge and Wet, where bubbles are flat, the grain is never negative: it raises the
/// bubbles between the films. If only the walls of a maze shape the relief (ReliefFilms::Walls),
/// there is no grain, and the distance to the nearest wall replaces the smooth distance. There are
/// then also creases where two walls are equally near. Around a patch the relief is flat, except
/// for the outer half of ridges and wet films. Borrows the layers.
class Relief {
  public:
    /// In a relief of walls, distances to the nearest wall above `reach` count as infinite. `reach`
    /// is in units of the section (ReliefSection). It has no effect on reliefs of all films.
    Relief(FrameLayers& layers, const ReliefSource& source, double reach);
    /// The `reach` that suffices if only heights and slopes are used, because the relief is flat
    /// beyond the foot of ridges and of Plateau borders.
    static constexpr double kFoot = 1.0;

    Relief(const Relief&) = delete;
    Relief& operator=(const Relief&) = delete;

    /// Return the height in pixels, and the gradient of the height (x to the right, y up), at a
    /// pixel. `index` counts pixels row by row from the bottom row.
    double height(std::size_t index) const;
    Vec2 slope(std::size_t index) const;

    /// Returns the unit of length of the section (ReliefSection) at a pixel, in pixels. For domes
    /// it is 0 around a patch.
    double unit(std::size_t index) const {
        return ids_ == nullptr ? width_ : radii_[ids_->samples()[index]];
    }
    /// Returns the smooth distance at a pixel, in units of the section. Precondition: the unit is
    /// above 0.
    double smooth(std::size_t index) const {
        return static_cast<double>(smooth_->samples()[index]) / unit(index);
    }
    const ReliefSection& section() const { return section_; }
    /// Returns the factor on heights (ReliefOptions::strength).
    double strength() const { return strength_; }

    /// Returns the diameter of the mean bubble (ReliefOptions::mean_bubble) in pixels.
    double diameter() const { return diameter_; }

  private:
    /// Returns the height of the grain at a pixel, in pixels, and its gradient.
    GrainValue grain_at(std::size_t index) const;

    ReliefSection section_;
    double strength_;
    double diameter_;
    double width_;  // the unit of the section in pixels, except for domes
    const Image<float>* smooth_ = nullptr;
    const Image<float>* gradient_ = nullptr;     // of `smooth_`
    const Image<std::uint32_t>* ids_ = nullptr;  // of the distance field; only for domes
    std::vector<double> radii_;                  // units of domes, indexed by these ids
    std::optional<Grain> grain_;
    double grain_height_;  // factor on the values of the grain, pixels
};

}  // namespace foam::texgen
