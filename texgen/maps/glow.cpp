// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/glow.h"

#include "texgen/maps/albedo.h"
#include "texgen/maps/film_coverage.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {

namespace {

// Returns the weight of every pixel for glow_fractions: the fraction of its color that is emitted
// as light if the glow is 1. In a patch, the caller divides the weight by the opacity.
Image<float> glow_weights(FrameLayers& layers, const SurfaceColors& surface) {
    if (surface.map == LitColors::Maze) {
        return maze_wall_coverage(layers, surface.maze);
    }
    Image<float> weights = film_coverage(layers, surface.albedo);
    if (surface.albedo.shade > 0.0) {
        const Image<float> shade = film_shade(layers, surface.albedo);
        std::ranges::transform(weights.samples(),
                               shade.samples(),
                               weights.samples().begin(),
                               [](float film, float beside) { return std::max(film, beside); });
    }
    return weights;
}

// Converts fractions of whole pixels to fractions of the part of each pixel that a patch covers.
void divide_by_opacity(const Image<std::uint16_t>& colors, Image<float>& fractions) {
    const auto channels = static_cast<std::size_t>(colors.channels());
    for (std::size_t k = 0; k < fractions.samples().size(); ++k) {
        const std::uint16_t opacity = colors.samples()[channels * k + channels - 1];
        const float whole = static_cast<float>(opacity) / static_cast<float>(kWhite);
        float& fraction = fractions.samples()[k];
        fraction = whole > 0.0F ? std::min(fraction / whole, 1.0F) : 0.0F;
    }
}

}  // namespace

ColorPixels draw_surface_colors(FrameLayers& layers, const SurfaceColors& surface) {
    switch (surface.map) {
        case LitColors::Albedo:
            return draw_albedo(layers, surface.albedo);
        case LitColors::ThinFilm:
            return draw_thin_film(layers, surface.thin_film, surface.albedo);
        case LitColors::Maze:
            return draw_maze(layers, surface.maze);
    }
    return {};
}

Image<float> glow_fractions(FrameLayers& layers,
                            const SurfaceColors& surface,
                            const ColorPixels& colors,
                            double glow) {
    Image<float> fractions = glow_weights(layers, surface);
    if (layers.is_patch()) {
        divide_by_opacity(colors.pixels, fractions);
    }
    for (float& fraction : fractions.samples()) {
        fraction *= static_cast<float>(glow);
    }
    return fractions;
}

}  // namespace foam::texgen
