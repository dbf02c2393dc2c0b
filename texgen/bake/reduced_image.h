// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulated_frame.h"
#include "texgen/preset/preset.h"

#include <optional>

namespace foam::texgen {

/// The images of a preset at a smaller size of exactly the same aspect ratio. They show the same
/// part of the foam. The width of films (albedo.film_width) and the range of the map `distance`
/// (distance.full) are reduced with the image if the preset gives them in pixels.
struct ReducedImage {
    int width = 0;
    int height = 0;
    double reduction = 1.0;  // width of the full image divided by the width of the reduced image
    MapOptions options;

    /// Returns the grid of a frame at the reduced size. `view` is the view of the frame at full
    /// size (SimulatedFrame::view).
    RasterGrid grid(std::optional<View> view) const;

    /// Gives a preset the size and the options of these images.
    void apply_to(Preset& preset) const;
};

/// Returns the largest reduced image of a preset whose longer side has at most `side` pixels. If
/// there is none, because the width and the height have too small a common divisor, returns the
/// smallest image of exactly the same aspect ratio. The result is never larger than the image of
/// the preset. Precondition: `side` is positive.
ReducedImage reduced_image(const Preset& preset, int side);

}  // namespace foam::texgen
