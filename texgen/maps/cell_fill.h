// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/per_bubble.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Returns an image of bubbles in the given colors and of films in the color `film`. A pixel that
/// several bubbles and films share has the mean of their linear light, weighted by exact area. In a
/// cross-fade, the border between the two foams (FadeBorder) is painted as a film, with approximate
/// areas (line_coverage). The surroundings of a patch are transparent: the opacity is the fraction
/// of a pixel that the patch covers, including the outer half of its outer films. The samples of
/// fully transparent pixels are 0. The film width is in pixels. Throws as cell_arcs and fill_cells
/// do.
ColorPixels fill_colors(FrameLayers& layers,
                        const PerBubble<LinearRgb>& colors,
                        const LinearRgb& film,
                        double film_width);

/// A number for every bubble, and one number for all films.
struct CellNumbers {
    PerBubble<double> bubbles;
    double film = 0.0;
};

/// Returns an image whose pixels are means of the numbers of the bubbles and films in them,
/// weighted by exact area. The numbers and their means are rounded to a scale of 65535 equal steps,
/// from the smallest to the largest number. Pixels around a patch are 0; a pixel on the rim of the
/// patch has the mean over the part that the patch covers. The border of a cross-fade is painted as
/// in fill_colors. The film width is in pixels. The image has one channel. Throws as cell_arcs and
/// fill_cells do.
Image<float> fill_numbers(FrameLayers& layers, const CellNumbers& numbers, double film_width);

/// Returns the image that the function above returns for a film width of 0. Films are then not
/// visible.
Image<float> fill_numbers(FrameLayers& layers, const PerBubble<double>& bubbles);

/// Returns a table of radii in pixels, indexed by the ids of a DistanceField. The radius of a
/// bubble is the radius of a circle with the area of the bubble. The surroundings of a patch have
/// the radius `around`.
std::vector<double> radii_by_cell_id(const FrameLayers& layers, double around);

/// Returns an image in which each pixel has the integer of the bubble at the center of the pixel,
/// or 0 around a patch. Integers are not mixed. The image has one channel.
IdPixels paint_ids(FrameLayers& layers, const PerBubble<std::uint32_t>& ids);

/// The part of the foam that a mask covers: films only, or bubbles and films.
enum class Part { Films, Foam };

/// Returns the fraction of every pixel that a part of the foam covers. The film width is in pixels;
/// outer films of a patch extend outward by half of this width. The border of a cross-fade is
/// painted as in fill_colors. The image has one channel with values from 0 to 1 in steps of
/// 1/65535. Throws as cell_arcs and fill_cells do.
Image<float> fill_coverage(FrameLayers& layers, Part part, double film_width);

}  // namespace foam::texgen
