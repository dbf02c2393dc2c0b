// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/arc_distance.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// Draws strokes with round ends along arcs. Returns the fraction of every pixel that the strokes
/// cover (stroke_coverage). `width` is the full width of a stroke, in diameters of a mean bubble of
/// the seeded foam.
Image<float> strokes_along(const FrameLayers& layers,
                           std::span<const PlacedArc> arcs,
                           double width);

/// A layer of one color.
struct PaintLayer {
    std::string color;      // sRGB
    Image<float> coverage;  // the fraction of every pixel that the layer covers, in one channel
};

/// Returns an image of the layers `painted` over a ground of one sRGB color. A later layer covers
/// earlier layers. Around a patch, pixels that no layer covers are transparent. Throws
/// std::invalid_argument if a color is invalid.
ColorPixels paint_layers(FrameLayers& layers,
                         const std::string& ground,
                         std::span<const PaintLayer> painted);

}  // namespace foam::texgen
