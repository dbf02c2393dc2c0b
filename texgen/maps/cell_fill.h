#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/per_bubble.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Colors bubbles and films. A pixel that they share has the mean of their light, by exact area.
/// The surroundings of a patch are transparent: the opacity is the fraction of a pixel that the
/// patch covers, with outer films to half their width outwards. Transparent pixels have colors of
/// opaque pixels nearby (bleed_colors). The width is in pixels. Throws as fill_cells does.
ColorPixels fill_colors(FrameLayers& layers,
                        const PerBubble<LinearRgb>& colors,
                        const LinearRgb& film,
                        double film_width);

/// Numbers of bubbles, and the one that films have.
struct CellNumbers {
    PerBubble<double> bubbles;
    double film = 0.0;
};

/// Gives every pixel the mean of the numbers in it, weighted by exact area. Numbers are taken in
/// 65535 steps from the smallest to the largest. Around a patch the number is 0, and a pixel on its
/// rim has that of the part that is covered. One channel. Throws as fill_cells does.
Image<float> fill_numbers(FrameLayers& layers, const CellNumbers& numbers, double film_width);

/// The same with films of no width.
Image<float> fill_numbers(FrameLayers& layers, const PerBubble<double>& bubbles);

/// Returns a table of values by the ids of a DistanceField: first the bubbles, then, in a patch,
/// `around` for all that lies around it, then the lone bubbles.
template <class Value>
std::vector<Value> by_cell_id(const FrameLayers& layers, PerBubble<Value> values, Value around) {
    if (layers.is_patch()) {
        const auto bubbles = static_cast<std::ptrdiff_t>(layers.frame().bubbles.size());
        values.insert(values.begin() + bubbles, around);
    }
    return values;
}

/// Gives every pixel the integer of the bubble at its middle; 0 around a patch. One channel.
IdPixels paint_ids(FrameLayers& layers, const PerBubble<std::uint32_t>& ids);

enum class Part { Films, Foam };

/// Returns the fraction of every pixel that films, or bubbles and films together, cover; 0 around a
/// patch. One channel, in 65535 steps from 0 to 1. Throws as fill_cells does.
Image<float> fill_cover(FrameLayers& layers, Part part, double film_width);

}  // namespace foam::texgen
