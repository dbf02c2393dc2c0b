// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_coverage.h"

#include "core/parallel/simd_level.h"
#include "texgen/maps/color_loops.h"
#include "texgen/maps/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace foam::texgen {

namespace {

// The smallest slope of the smooth distance (raster/distance/distance_field.h) that is used;
// smaller slopes are replaced by it, because a distance is divided by the slope. Smaller slopes
// occur only near the middle of a bubble. The edge of a film reaches this region only if the film
// nearly fills the bubble.
constexpr double kSmallestSlope = 0.05;

// Returns the fraction of every pixel that wet films cover. A wet film covers the points whose
// smooth distance is below half its width. The signed distance from a pixel's center to the film's
// edge is positive inside the film. To first order, it is
//     (half the width - smooth distance) / slope of the smooth distance.
// The coverage grows linearly with this distance, from 0 at -1/2 pixel to 1 at 1/2 pixel.
Image<float> wet_films(FrameLayers& layers, double width) {
    Image<float> films(layers.grid().width, layers.grid().height, 1);
    if (width == 0.0) {
        return films;
    }
    const DistanceField& field = layers.distance();
    at_simd_level([count = films.samples().size(),
                   parts = films.samples().data(),
                   distances = field.smooth.samples().data(),
                   slopes = field.smooth_gradient.samples().data(),
                   half_width = 0.5 * width] {
        for (std::size_t k = 0; k < count; ++k) {
            const auto x = static_cast<double>(slopes[2 * k]);
            const auto y = static_cast<double>(slopes[2 * k + 1]);
            const double steepness = max_value(std::sqrt(x * x + y * y), kSmallestSlope);
            const double inside = half_width - static_cast<double>(distances[k]);
            const double part = 0.5 + inside / steepness;
            parts[k] = static_cast<float>(min_value(max_value(part, 0.0), 1.0));
        }
    });
    return films;
}

// Returns the colors of an image with the given opacities. Transparent pixels are black.
Image<std::uint16_t> with_opacity(const Image<std::uint16_t>& colors, const Image<float>& opacity) {
    Image<std::uint16_t> image(colors.width(), colors.height(), kChannelsWithOpacity);
    const auto channels = static_cast<std::size_t>(colors.channels());
    for (std::size_t k = 0; k < opacity.samples().size(); ++k) {
        const float whole = opacity.samples()[k];
        if (whole > 0.0F) {
            const auto pixel = image.samples().subspan(kChannelsWithOpacity * k, 4);
            std::ranges::copy(colors.samples().subspan(channels * k, 3), pixel.begin());
            pixel[3] = to_sample(static_cast<double>(whole));
        }
    }
    return image;
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
    at_simd_level([count = shade.samples().size(),
                   weights = shade.samples().data(),
                   distances = field.smooth.samples().data(),
                   width,
                   strongest = options.shade] {
        for (std::size_t k = 0; k < count; ++k) {
            const double passed = min_value(static_cast<double>(distances[k]) / width, 1.0);
            weights[k] = static_cast<float>(strongest * (1.0 - smooth_step(passed)));
        }
    });
    return shade;
}

Image<float> fill_numbers(FrameLayers& layers,
                          const CellNumbers& numbers,
                          const AlbedoOptions& options) {
    if (options.film_profile == FilmProfile::Even) {
        const double width = film_width_in_pixels(options, layers.grid(), layers.frame().domain);
        return fill_numbers(layers, numbers, width);
    }
    Image<float> image = fill_numbers(layers, numbers.bubbles);
    const Image<float> coverage = film_coverage(layers, options);
    const Image<float> foam = foam_coverage(layers, options, coverage);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        const float whole = foam.samples()[k];
        const float part = whole > 0.0F ? coverage.samples()[k] / whole : 0.0F;
        image.samples()[k] = std::lerp(image.samples()[k], static_cast<float>(numbers.film), part);
    }
    return image;
}

SmoothImages film_smooth_images(const AlbedoOptions& options) {
    if (options.film_profile == FilmProfile::Wet) {
        return SmoothImages::DistanceAndGradient;
    }
    return options.shade > 0.0 ? SmoothImages::Distance : SmoothImages::None;
}

ColorPixels paint_films(FrameLayers& layers, const AlbedoOptions& options, ColorPixels colors) {
    const LinearRgb film = to_linear(parse_color(options.film_color));
    Image<float> films = film_coverage(layers, options);
    if (!layers.is_patch()) {
        mix_in(film, films, colors.pixels);
        return colors;
    }
    // At the rim, a pixel shows the mean color of the part of the pixel that the patch covers.
    // The coverage of films is therefore converted to a fraction of this part.
    const Image<float> foam = foam_coverage(layers, options, films);
    for (std::size_t k = 0; k < foam.samples().size(); ++k) {
        const float whole = foam.samples()[k];
        films.samples()[k] = whole > 0.0F ? films.samples()[k] / whole : 0.0F;
    }
    mix_in(film, films, colors.pixels);
    return {with_opacity(colors.pixels, foam),
            {to_sample(film.r), to_sample(film.g), to_sample(film.b)}};
}

}  // namespace foam::texgen
