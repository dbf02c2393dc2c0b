// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo.h"

#include "texgen/image/color.h"
#include "texgen/maps/cell_color.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/color_loops.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/grain.h"

#include <array>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

ColorPixels draw_flat(FrameLayers& layers, const AlbedoOptions& options) {
    const double width = film_width_in_pixels(options, layers.grid(), layers.frame().domain);
    return fill_colors(layers,
                       cell_colors(layers.frame(), layers.record(), options, layers.first()),
                       to_linear(parse_color(options.film_color)),
                       width);
}

// Multiplies each color by 1 plus `options.grain` times the value of the grain.
void add_grain(FrameLayers& layers, const AlbedoOptions& options, ColorPixels& colors) {
    const Grain& grain = layers.grain({options.grain_size, GrainUse::Albedo});
    change_colors(
        colors.pixels,
        [values = grain.value.samples().data(), strength = static_cast<float>(options.grain)](
            const std::array<float, 3>& color, std::size_t k) {
            const float factor = 1.0F + strength * values[k];
            return std::array{factor * color[0], factor * color[1], factor * color[2]};
        });
}

// Draws the colors of bubbles first; a pixel that bubbles share has their mean color. Then applies
// the grain to these colors, mixes in the shade beside films, and paints the films over the result.
ColorPixels draw_shaded(FrameLayers& layers, const AlbedoOptions& options) {
    const LinearRgb film = to_linear(parse_color(options.film_color));
    ColorPixels colors = fill_colors(
        layers, cell_colors(layers.frame(), layers.record(), options, layers.first()), film, 0.0);
    if (options.grain > 0.0) {
        add_grain(layers, options, colors);
    }
    if (options.shade > 0.0) {
        mix_in(to_linear(parse_color(options.shade_color)),
               film_shade(layers, options),
               colors.pixels);
    }
    return paint_films(layers, options, std::move(colors));
}

}  // namespace

ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options) {
    const bool is_flat = film_smooth_images(options) == SmoothImages::None && options.grain == 0.0;
    return is_flat ? draw_flat(layers, options) : draw_shaded(layers, options);
}

}  // namespace foam::texgen
