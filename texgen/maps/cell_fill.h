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

/// Fills bubbles and films with colors. A pixel that several of them share has the mean of their
/// linear light, weighted by exact area. The surroundings of a patch are transparent: the opacity
/// is the fraction of a pixel that the patch covers, including the outer half of its outer films.
/// Transparent pixels take the colors of opaque pixels nearby (bleed_colors). The film width is in
/// pixels. Throws as fill_cells does.
ColorPixels fill_colors(FrameLayers& layers,
                        const PerBubble<LinearRgb>& colors,
                        const LinearRgb& film,
                        double film_width);

/// A number for every bubble, and one number for all films.
struct CellNumbers {
    PerBubble<double> bubbles;
    double film = 0.0;
};

/// Gives every pixel the mean of the numbers in it, weighted by exact area. Numbers are rounded to
/// 65535 steps from the smallest to the largest. Around a patch the number is 0; a pixel on its rim
/// has the mean of its covered part. The film width is in pixels. The image has one channel. Throws
/// as fill_cells does.
Image<float> fill_numbers(FrameLayers& layers, const CellNumbers& numbers, double film_width);

/// Fills an image as the function above does for a film width of 0: only numbers of bubbles count.
Image<float> fill_numbers(FrameLayers& layers, const PerBubble<double>& bubbles);

/// Returns a table of values indexed by the ids of a DistanceField. The values of the bubbles of
/// the network come first. In a patch they are followed by `around`, the value of the surroundings,
/// and by the values of the lone bubbles.
template <class Value>
std::vector<Value> by_cell_id(const FrameLayers& layers, PerBubble<Value> values, Value around) {
    if (layers.is_patch()) {
        const auto bubbles = static_cast<std::ptrdiff_t>(layers.frame().bubbles.size());
        values.insert(values.begin() + bubbles, around);
    }
    return values;
}

/// Gives every pixel the integer of the bubble at its center, and 0 around a patch. The image has
/// one channel.
IdPixels paint_ids(FrameLayers& layers, const PerBubble<std::uint32_t>& ids);

/// The part of a picture that a mask covers: films only, or bubbles and films.
enum class Part { Films, Foam };

/// Returns the fraction of every pixel that a part of the foam covers, and 0 around a patch. The
/// film width is in pixels. The image has one channel with values from 0 to 1 in steps of 1/65535.
/// Throws as fill_cells does.
Image<float> fill_cover(FrameLayers& layers, Part part, double film_width);

}  // namespace foam::texgen
