// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/relief_section.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// The relief of a frame: a surface whose height varies over the foam, at the centers of pixels.
/// Heights come from the smooth distance and slopes from its gradient, so that there are creases
/// only along films. Around a patch the relief is flat, except for the outer half of ridges and wet
/// films. Borrows the layers.
class Relief {
  public:
    Relief(FrameLayers& layers, const ReliefOptions& options);

    /// Return the height in pixels, and the gradient of the height (x to the right, y up), at a
    /// pixel. `index` counts pixels row by row from the bottom row.
    double height(std::size_t index) const;
    Vec2 slope(std::size_t index) const;

    /// Returns the unit of length of the section (ReliefSection) at a pixel, in pixels. For domes
    /// it is 0 around a patch.
    double unit(std::size_t index) const { return units_[field_.ids.samples()[index]]; }
    /// Returns the smooth distance at a pixel, in units of the section. Precondition: the unit is
    /// above 0.
    double smooth(std::size_t index) const {
        return static_cast<double>(field_.smooth.samples()[index]) / unit(index);
    }
    const ReliefSection& section() const { return section_; }

    /// Returns the diameter of the mean bubble (ReliefOptions::mean_bubble) in pixels.
    double diameter() const { return diameter_; }

  private:
    const DistanceField& field_;
    ReliefSection section_;
    double strength_;
    double diameter_;
    std::vector<double> units_;  // indexed by the ids of the distance field
};

}  // namespace foam::texgen
