// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_strokes.h"

#include "core/foam/measure.h"
#include "texgen/image/color.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace foam::texgen {

Image<float> strokes_along(const FrameLayers& layers,
                           std::span<const PlacedArc> arcs,
                           double width) {
    const RasterGrid& grid = layers.grid();
    const Domain& domain = layers.frame().domain;
    const double pixels = diameters_in_pixels(width, grid, domain);
    return stroke_coverage(
        distances_to_arcs(arcs, grid, domain, stroke_needs(pixels), layers.threads()).distance,
        pixels);
}

ColorPixels paint_layers(FrameLayers& layers,
                         const std::string& ground,
                         std::span<const PaintLayer> painted) {
    const LinearRgb ground_color = to_linear(parse_color(ground));
    std::vector<LinearRgb> colors;
    for (const PaintLayer& layer : painted) {
        colors.push_back(to_linear(parse_color(layer.color)));
    }
    const RasterGrid& grid = layers.grid();
    const Image<float> foam =
        layers.is_patch() ? fill_coverage(layers, Part::Foam, 0.0) : Image<float>();
    const std::size_t channels = layers.is_patch() ? 4 : 3;
    Image<std::uint16_t> image(grid.width, grid.height, static_cast<int>(channels));
    const std::size_t pixels = image.samples().size() / channels;
    for (std::size_t k = 0; k < pixels; ++k) {
        LinearRgb color = ground_color;
        double opacity = layers.is_patch() ? static_cast<double>(foam.samples()[k]) : 1.0;
        for (std::size_t layer = 0; layer < painted.size(); ++layer) {
            const auto part = static_cast<double>(painted[layer].coverage.samples()[k]);
            // Where the ground is transparent, only the color of the layer is visible.
            opacity = std::max(opacity, part);
            color = mixed(color, colors[layer], opacity > 0.0 ? part / opacity : 0.0);
        }
        write_pixel(color, opacity, image.samples().subspan(channels * k, channels));
    }
    return {std::move(image),
            {to_sample(ground_color.r), to_sample(ground_color.g), to_sample(ground_color.b)}};
}

}  // namespace foam::texgen
