#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/relief_section.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// The relief of a frame, at the centers of pixels. Heights come from the smooth distance, and
/// slopes from its gradient: there are creases only along films. Around a patch it is flat, except
/// for the outer halves of ridges and borders. Borrows the layers.
class Relief {
  public:
    Relief(FrameLayers& layers, const ReliefOptions& options);

    /// Return the height (pixels) and the slope at a pixel, counted row by row.
    double height(std::size_t index) const;
    Vec2 slope(std::size_t index) const;

    /// Returns the section's unit there, in pixels; 0 around a patch.
    double unit(std::size_t index) const { return units_[field_.ids.samples()[index]]; }
    /// Returns the smooth distance in that unit. Precondition: the unit is above 0.
    double smooth(std::size_t index) const {
        return static_cast<double>(field_.smooth.samples()[index]) / unit(index);
    }
    const ReliefSection& section() const { return section_; }

    /// Returns the diameter of the mean bubble in pixels.
    double diameter() const { return diameter_; }

  private:
    const DistanceField& field_;
    ReliefSection section_;
    double strength_;
    double diameter_;
    std::vector<double> units_;  // by id
};

}  // namespace foam::texgen
