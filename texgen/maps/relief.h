#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/relief_section.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// The relief of a frame, at the middle of pixels. Heights come from the smooth distance, and
/// slopes from its gradient: there are no creases but along films. Around a patch it is flat, but
/// for the outer halves of ridges and borders. Borrows the layers.
class Relief {
  public:
    Relief(FrameLayers& layers, const ReliefOptions& options);

    /// Of the pixel that comes at place `index`, row by row: in pixels, and pixels by pixels.
    double height(std::size_t index) const;
    Vec2 slope(std::size_t index) const;

    /// The section's unit there, in pixels; 0 where there is nothing.
    double unit(std::size_t index) const { return units_[field_.ids.samples()[index]]; }
    /// The smooth distance in that unit. Precondition: it is above 0.
    double smooth(std::size_t index) const {
        return static_cast<double>(field_.smooth.samples()[index]) / unit(index);
    }
    const ReliefSection& section() const { return section_; }

    /// Of the mean bubble, in pixels.
    double diameter() const { return diameter_; }

  private:
    const DistanceField& field_;
    ReliefSection section_;
    double strength_;
    double diameter_;
    std::vector<double> units_;  // by id
};

}  // namespace foam::texgen
