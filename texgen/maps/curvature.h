// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/map.h"
#include "texgen/maps/relief.h"

namespace foam::texgen {

inline constexpr MapTraits kCurvatureMap = {
    .name = "curvature",
    .meaning = "curvature of the relief: above 0 on crests, below 0 in furrows",
    .unit = "per bubble diameter; in a PNG, 0.5 stands for 0, and 1 stands for curvature.full",
    .channels = "Y",
    .png_bits = 16,
    .png_filter = PngFilter::Up,
    .smooth_images = SmoothImages::Distance,
    .shows_relief = true,
    .full_key = "curvature.full"};

struct CurvatureOptions {
    // The height at a point is compared with the heights at this distance on both sides of it. The
    // unit is the diameter of the mean bubble (ReliefOptions::mean_bubble).
    double radius = 0.08;
    // The curvature that a PNG stores as its largest code (65535), per diameter of the mean bubble
    // (ReliefOptions::mean_bubble). Code 0 stands for -full.
    AutoReal full{10.0, true};
};

Keys<CurvatureOptions> curvature_keys();

/// Draws the curvature of the relief across the nearest film, times the diameter of the mean
/// bubble. The curvature is a difference of heights:
///     (2 h(x) - h(x - a) - h(x + a)) / a².
/// Here x is the distance of the pixel from the film, and a is the length options.radius. The
/// height h(x) is the height at the distance x in the cross-section of the relief (height_along in
/// relief_section.h), times ReliefOptions::strength. The curvature is positive on crests, negative
/// in furrows, and 0 where the relief is flat or has a constant slope. The image has one channel
/// and is 0 around a patch, apart from the outer half of ridges and wet films, and from the points
/// that are at most options.radius away from this half.
NumberPixels draw_curvature(FrameLayers& layers,
                            const ReliefSource& source,
                            const CurvatureOptions& options);

}  // namespace foam::texgen
