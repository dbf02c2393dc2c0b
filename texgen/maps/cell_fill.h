#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Something of every bubble of a frame: of those in the network by their id, then of the lone
/// ones.
template <class Value>
using PerBubble = std::vector<Value>;

/// of(bubble) of every bubble of the network, of_lone(bubble) of every lone one.
template <class Value, class Of, class OfLone>
PerBubble<Value> per_bubble(const Frame& frame, const Of& of, const OfLone& of_lone) {
    PerBubble<Value> values;
    values.reserve(frame.bubbles.size() + frame.lone_bubbles.size());
    for (std::size_t k = 0; k < frame.bubbles.size(); ++k) {
        values.push_back(of(id_at<BubbleId>(k)));
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        values.push_back(of_lone(bubble));
    }
    return values;
}

/// Colours bubbles and films. A pixel that they share has the mean of their light, by exact area.
/// What is around a patch is transparent: the opacity is the part of a pixel that the patch covers,
/// its outer films to half their width outwards. Where there is no opacity, colours are those of
/// the opaque pixels around (bleed_colors). The width is in pixels. Throws as fill_cells does.
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

/// Values by the ids of a DistanceField: those of bubbles, with that of what is around a patch in
/// between.
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

/// Of every pixel the part that films, or bubbles and films together, cover; 0 around a patch. One
/// channel, in 65535 steps from 0 to 1. Throws as fill_cells does.
Image<float> fill_cover(FrameLayers& layers, Part part, double film_width);

}  // namespace foam::texgen
