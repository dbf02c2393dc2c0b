// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo.h"

#include "texgen/image/color.h"
#include "texgen/maps/cell_color.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/grain.h"
#include "texgen/maps/quantize.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace foam::texgen {

namespace {

ColorPixels draw_flat(FrameLayers& layers, const AlbedoOptions& options) {
    const double width = film_width_in_pixels(options, layers.grid(), layers.frame().domain);
    return fill_colors(layers,
                       cell_colors(layers.frame(), layers.record(), options),
                       to_linear(parse_color(options.film_color)),
                       width);
}

// Multiplies each component of a color by 1 + change, and clamps it to [0, 1].
LinearRgb grained(const LinearRgb& color, double change) {
    const auto changed = [&](double x) { return std::clamp(x * (1.0 + change), 0.0, 1.0); };
    return {changed(color.r), changed(color.g), changed(color.b)};
}

// Draws the colors of bubbles first; a pixel that bubbles share has their mean color. Then applies
// the grain to these colors, mixes in the shade beside films, and paints the films over the result.
ColorPixels draw_shaded(FrameLayers& layers, const AlbedoOptions& options) {
    const LinearRgb film = to_linear(parse_color(options.film_color));
    const ColorPixels cells =
        fill_colors(layers, cell_colors(layers.frame(), layers.record(), options), film, 0.0);
    const auto channels = static_cast<std::size_t>(cells.pixels.channels());
    std::optional<Grain> grain;
    if (options.grain > 0.0) {
        grain.emplace(layers, options.grain_size, GrainUse::Albedo);
    }
    const auto color_at = [&](std::size_t k) {
        const auto pixel = cells.pixels.samples().subspan(channels * k, 3);
        const LinearRgb color{pixel[0] / kWhite, pixel[1] / kWhite, pixel[2] / kWhite};
        return grain ? grained(color, options.grain * grain->at(k).value) : color;
    };
    if (options.shade == 0.0) {
        return paint_films(layers, options, color_at);
    }
    const LinearRgb shade = to_linear(parse_color(options.shade_color));
    const Image<float> weights = film_shade(layers, options);
    return paint_films(layers, options, [&](std::size_t k) {
        return mixed(color_at(k), shade, static_cast<double>(weights.samples()[k]));
    });
}

}  // namespace

ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options) {
    const bool is_flat = !film_distance_needs(options).smooth && options.grain == 0.0;
    return is_flat ? draw_flat(layers, options) : draw_shaded(layers, options);
}

Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads) {
    const FoamRecord record;
    FrameLayers layers({frame, record, nullptr, film_distance_needs(options)}, grid, threads);
    return srgb_codes(draw_albedo(layers, options));
}

}  // namespace foam::texgen
