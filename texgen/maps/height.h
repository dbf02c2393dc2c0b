// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief.h"

namespace foam::texgen {

inline constexpr MapTraits kHeightMap = {
    .name = "height",
    .meaning = "relief: domes, ridges on films, or wet films with Plateau borders",
    .unit = "bubble diameters; PNG: 0 to height.full",
    .channels = "Y",
    .png_bits = 16,
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::Distance,
    .shows_relief = true,
    .full_key = "height.full"};

struct HeightOptions {
    // The height that a PNG stores as its largest code (65535), in diameters of the relief's mean
    // bubble (the bubble that ReliefOptions::mean_bubble selects).
    AutoReal full{0.5, true};
};

Keys<HeightOptions> height_keys();

/// Draws the height of the relief, in diameters of the relief's mean bubble. The image has one
/// channel and is 0 around a patch, apart from the outer half of ridges and wet films.
NumberPixels draw_height(FrameLayers& layers,
                         const ReliefSource& source,
                         const HeightOptions& options);

/// Returns the unit of heights (the diameter of the relief's mean bubble) as a fraction of the
/// width of the image. A program that displaces a surface needs this number.
double height_unit(const FrameLayers& layers, const ReliefOptions& options);

}  // namespace foam::texgen
