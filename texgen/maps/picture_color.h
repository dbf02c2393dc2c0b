// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/color.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_one.h"
#include "texgen/maps/per_bubble.h"

namespace foam::texgen {

/// Returns the mean color of options.picture under every bubble, in the frame that
/// options.picture_sampling selects. The picture is stretched over the torus, or over the bounding
/// box of the patch in frame 1. The color of a bubble is the mean of samples in linear light. The
/// distance between samples is at most the side of a pixel of the picture, or 1/512 of the longer
/// side of the picture if this is more. In large bubbles the distance can be larger, because the
/// number of samples is limited (visit_polygon_samples). The colors do not depend on the size of
/// the drawn image. With PictureSampling::FirstFrame, the colors in frame 1 (`first`) are computed
/// only once, and used in all frames; a bubble that is not in frame 1 has the color under it in
/// the present frame. Transparent parts of the picture are white. Throws std::invalid_argument if
/// there is no picture.
PerBubble<LinearRgb> picture_colors(const Frame& frame,
                                    const FrameOne& first,
                                    const AlbedoOptions& options);

}  // namespace foam::texgen
