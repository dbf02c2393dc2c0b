// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/bubble_values.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/frame_one.h"

#include <vector>

namespace foam::texgen {

/// Returns the position of every bubble on the scale of options.color_by: 0 is the start of the
/// scale, 1 its end. Pressures, areas and numbers of sides are averages over recent frames if the
/// record has them (shown_values). Pressures and numbers of sides beyond the scale have positions
/// outside [0, 1]. With ColorBy::Picture, the positions are the same as with ColorBy::Random.
/// Throws std::invalid_argument if options.color_by is Pressure and pressure_low is not below
/// pressure_high.
PerBubble<double> scale_positions(const Frame& frame,
                                  const FoamRecord& record,
                                  const AlbedoOptions& options);

/// Returns the color of every bubble: a base color times a factor. The base color is the color at
/// the bubble's position on the scale or, with ColorBy::Picture, the mean color of the picture
/// under the bubble (picture_colors). Positions are clamped to [0, 1]. The factor differs from 1 by
/// at most options.variation, and a bubble keeps it for life. The components of the result are
/// clamped to [0, 1]. With ColorBy::Picture, throws std::invalid_argument if there is no picture.
/// With all other values of options.color_by, throws std::invalid_argument if options.colors is
/// invalid (parse_gradient), or if this list is empty and the color map is unknown. Also throws as
/// scale_positions does. `first` is frame 1, which only ColorBy::Picture uses; if it is null, the
/// frame itself takes its place.
PerBubble<LinearRgb> cell_colors(const Frame& frame,
                                 const FoamRecord& record,
                                 const AlbedoOptions& options,
                                 const FrameOne* first = nullptr);

}  // namespace foam::texgen
