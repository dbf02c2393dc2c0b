// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_coverage.h"

#include "texgen/image/bleed.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

// The smallest slope of the smooth distance (raster/distance/distance_field.h) that is used;
// smaller slopes are replaced by it, because a distance is divided by the slope. Smaller slopes
// occur only near the middle of bubbles, which the edge of a film reaches only if the film nearly
// fills its bubbles.
constexpr double kFlattest = 0.05;

// Returns the fraction of every pixel that wet films cover. A wet film covers the points whose
// smooth distance is below half its width. The signed distance from a pixel's center to the film's
// edge, positive inside the film, is estimated to first order:
//     (half the width - smooth distance) / slope of the smooth distance.
// The coverage grows linearly with this distance, from 0 at -1/2 pixel to 1 at 1/2 pixel.
Image<float> wet_films(FrameLayers& layers, double width) {
    Image<float> films(layers.grid().width, layers.grid().height, 1);
    if (width == 0.0) {
        return films;
    }
    const DistanceField& field = layers.distance();
    for (std::size_t k = 0; k < films.samples().size(); ++k) {
        const auto slope = field.smooth_gradient.samples().subspan(2 * k, 2);
        const double steepness =
            Vec2(static_cast<double>(slope[0]), static_cast<double>(slope[1])).norm();
        const double inside = 0.5 * width - static_cast<double>(field.smooth.samples()[k]);
        const double part = 0.5 + inside / std::max(steepness, kFlattest);
        films.samples()[k] = static_cast<float>(std::clamp(part, 0.0, 1.0));
    }
    return films;
}

}  // namespace

Image<float> film_coverage(FrameLayers& layers, const AlbedoOptions& options) {
    const double width = film_width_in_pixels(options, layers.grid(), layers.frame().domain);
    return options.film_profile == FilmProfile::Even ? fill_coverage(layers, Part::Films, width)
                                                     : wet_films(layers, width);
}

Image<float> foam_coverage(FrameLayers& layers, const AlbedoOptions& options) {
    const bool needs_films = layers.is_patch() && options.film_profile == FilmProfile::Wet;
    return foam_coverage(
        layers, options, needs_films ? film_coverage(layers, options) : Image<float>());
}

Image<float> foam_coverage(FrameLayers& layers,
                           const AlbedoOptions& options,
                           const Image<float>& films) {
    if (!layers.is_patch()) {
        Image<float> whole(layers.grid().width, layers.grid().height, 1);
        std::fill(whole.samples().begin(), whole.samples().end(), 1.0F);
        return whole;
    }
    if (options.film_profile == FilmProfile::Even) {
        const double width = film_width_in_pixels(options, layers.grid(), layers.frame().domain);
        return fill_coverage(layers, Part::Foam, width);
    }
    Image<float> foam = fill_coverage(layers, Part::Foam, 0.0);
    std::transform(foam.samples().begin(),
                   foam.samples().end(),
                   films.samples().begin(),
                   foam.samples().begin(),
                   [](float bubbles, float film) { return std::max(bubbles, film); });
    return foam;
}

Image<float> film_shade(FrameLayers& layers, const AlbedoOptions& options) {
    const double width =
        diameters_in_pixels(options.shade_width, layers.grid(), layers.frame().domain);
    const DistanceField& field = layers.distance();
    Image<float> shade(layers.grid().width, layers.grid().height, 1);
    std::transform(field.smooth.samples().begin(),
                   field.smooth.samples().end(),
                   shade.samples().begin(),
                   [&](float smooth) {
                       const double fraction = std::min(static_cast<double>(smooth) / width, 1.0);
                       return static_cast<float>(options.shade * (1.0 - smooth_step(fraction)));
                   });
    return shade;
}

DistanceNeeds film_distance_needs(const AlbedoOptions& options) {
    return {.smooth = options.film_profile == FilmProfile::Wet || options.shade > 0.0};
}

ColorPixels paint_films(FrameLayers& layers,
                        const AlbedoOptions& options,
                        const std::function<LinearRgb(std::size_t)>& color_at) {
    const LinearRgb film = to_linear(parse_color(options.film_color));
    const Image<float> films = film_coverage(layers, options);
    const Image<float> foam = foam_coverage(layers, options, films);
    const std::size_t channels = layers.is_patch() ? 4 : 3;
    const RasterGrid& grid = layers.grid();
    Image<std::uint16_t> image(grid.width, grid.height, static_cast<int>(channels));
    for (std::size_t k = 0; k < foam.samples().size(); ++k) {
        const auto whole = static_cast<double>(foam.samples()[k]);
        if (whole == 0.0) {
            continue;
        }
        const double part = static_cast<double>(films.samples()[k]) / whole;
        write_pixel(
            mixed(color_at(k), film, part), whole, image.samples().subspan(channels * k, channels));
    }
    if (layers.is_patch()) {
        bleed_colors(image.view(), {to_sample(film.r), to_sample(film.g), to_sample(film.b)});
    }
    return {std::move(image)};
}

}  // namespace foam::texgen
