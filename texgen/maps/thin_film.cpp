// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/thin_film.h"

#include "core/geometry/trigonometric.h"
#include "core/parallel/simd_level.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/color_loops.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/film_reflectance.h"
#include "texgen/maps/identity_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// The thickness of the soap film that spans a bubble depends on the position in the bubble. Liquid
// gathers at the rim and at the bottom, and swirls. A table contains the color for every nanometer
// of thickness.
//
// In this file, the position of a point in its bubble is a vector: the negative gradient of the
// smooth distance (raster/distance/distance_field.h). It is zero in the middle of the bubble and
// has length 1 at the rim. In a circle of radius R, it is the vector from the center to the point,
// divided by R.

// The largest thickness in the table of colors, in nanometers. Thicker films are practically gray.
constexpr int kThickest = 4000;

// Returns a color whose components are from 0 to 1: the given color, mixed with as little gray of
// the same luminance as possible. If the luminance is 1 or more, the result is white.
LinearRgb within_srgb(const LinearRgb& color) {
    const double gray =
        std::clamp(0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b, 0.0, 1.0);
    const auto [low, high] = std::minmax({color.r, color.g, color.b});
    double part = 1.0;
    part = low < 0.0 ? std::min(part, gray / (gray - low)) : part;
    part = high > 1.0 ? std::min(part, (1.0 - gray) / (high - gray)) : part;
    const auto inside = [&](double x) { return std::clamp(std::lerp(gray, x, part), 0.0, 1.0); };
    return {inside(color.r), inside(color.g), inside(color.b)};
}

// Returns the color of a film for every thickness from 0 to kThickest, in steps of a nanometer.
std::vector<LinearRgb> colors_of_thicknesses(double exposure) {
    static const std::vector<LinearRgb> reflectances = [] {
        std::vector<LinearRgb> all;
        for (int thickness = 0; thickness <= kThickest; ++thickness) {
            all.push_back(film_reflectance(thickness));
        }
        return all;
    }();
    std::vector<LinearRgb> colors;
    colors.reserve(reflectances.size());
    for (const LinearRgb& light : reflectances) {
        colors.push_back(within_srgb({exposure * light.r, exposure * light.g, exposure * light.b}));
    }
    return colors;
}

// The soap films that span the bubbles, indexed by the ids of the distance field.
struct Films {
    std::vector<double> thickness;  // thickness in the middle, nanometers; 0 around a patch
    // The radius of a circle with the bubble's area, in pixels; 1 around a patch.
    std::vector<double> radius;
    std::vector<double> phase;  // the phase of the swirls (swirl_at), radians; 0 around a patch
};

Films films_of(FrameLayers& layers, const ThinFilmOptions& options) {
    const Frame& frame = layers.frame();
    const auto thickness_of = [&](BubbleIdentity bubble) {
        const double number = identity_number(bubble, IdentityStream::Second) - 0.5;
        return options.thickness * (1.0 + options.variation * number);
    };
    const auto phase_of = [&](BubbleIdentity bubble) {
        return 2.0 * std::numbers::pi * identity_number(bubble, IdentityStream::First);
    };
    const auto bubble_numbers = [&](const auto& number_of) {
        return per_bubble<double>(
            frame,
            [&](BubbleId bubble) { return number_of(frame.bubbles[bubble].identity); },
            [&](const LoneBubble& bubble) { return number_of(bubble.identity); });
    };
    return {by_cell_id(layers.frame(), bubble_numbers(thickness_of), 0.0),
            radii_by_cell_id(layers, 1.0),
            by_cell_id(layers.frame(), bubble_numbers(phase_of), 0.0)};
}

// Returns a number from -1 to 1 that varies smoothly over a bubble: the sum of two crossed waves,
// one of which bends the other. The pattern is twisted about the middle of the bubble, so that the
// waves wind around it. (x, y) is the position in the bubble. `phase` turns the pattern and shifts
// the waves, so that bubbles differ.
double swirl_at(double x, double y, double phase) {
    // The angle by which the pattern at the rim is turned relative to the middle, in radians.
    constexpr double kTwist = 2.2;
    const auto [sine, cosine] = ieee::sincos_of_moderate(phase + kTwist * (x * x + y * y));
    const double at_x = cosine * x - sine * y;
    const double at_y = sine * x + cosine * y;
    const double across = ieee::sincos_of_moderate(2.5 * at_y + 3.0 * phase).sine;
    return 0.65 * ieee::sincos_of_moderate(4.0 * at_x + 1.5 * across + phase).sine + 0.35 * across;
}

// Returns the thickness of the soap films at the center of each pixel, in nanometers. The variable
// `rim` is 1 at the rim of a bubble. It is 0 in the middle, because the smooth distance in the
// middle of a circle of radius R is R / 2.
template <bool HasSwirls>
Image<float> thicknesses(const DistanceField& field,
                         const Films& films,
                         const ThinFilmOptions& options) {
    Image<float> image(field.ids.width(), field.ids.height(), 1);
    at_simd_level([count = image.samples().size(),
                   thicknesses = image.samples().data(),
                   ids = field.ids.samples().data(),
                   distances = field.smooth.samples().data(),
                   gradients = field.smooth_gradient.samples().data(),
                   middles = films.thickness.data(),
                   radii = films.radius.data(),
                   phases = films.phase.data(),
                   options] {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t id = ids[k];
            const auto x = static_cast<double>(-gradients[2 * k]);
            const auto y = static_cast<double>(-gradients[2 * k + 1]);
            const double rim =
                1.0 - min_value(2.0 * static_cast<double>(distances[k]) / radii[id], 1.0);
            double factor = 1.0 + options.drainage * rim * rim - options.gravity * y;
            if constexpr (HasSwirls) {
                factor += options.swirl * swirl_at(x, y, phases[id]);
            }
            thicknesses[k] = static_cast<float>(middles[id] * max_value(factor, 0.0));
        }
    });
    return image;
}

// Writes the colors of films of the given thicknesses, interpolated in a table, to an image of
// three channels.
void write_colors(const Image<float>& thicknesses,
                  const std::vector<LinearRgb>& table,
                  Image<std::uint16_t>& image) {
    change_colors(image,
                  [thicknesses = thicknesses.samples().data(), table = table.data()](
                      const std::array<float, 3>&, std::size_t k) {
                      const float thickness =
                          min_value(thicknesses[k], static_cast<float>(kThickest));
                      const int below = min_value(static_cast<int>(thickness), kThickest - 1);
                      const double part = static_cast<double>(thickness) - below;
                      const auto mixed = [=](double a, double b) {
                          return static_cast<float>(kWhite * (a + (b - a) * part));
                      };
                      return std::array{mixed(table[below].r, table[below + 1].r),
                                        mixed(table[below].g, table[below + 1].g),
                                        mixed(table[below].b, table[below + 1].b)};
                  });
}

// Writes a color to the pixels whose centers are around a patch.
void paint_surroundings(FrameLayers& layers, const LinearRgb& color, Image<std::uint16_t>& image) {
    const std::span<const std::uint32_t> ids = layers.distance().ids.samples();
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (layers.is_surroundings(ids[k])) {
            write_pixel(color, 1.0, image.samples().subspan(3 * k, 3));
        }
    }
}

}  // namespace

Keys<ThinFilmOptions> thin_film_keys() {
    return {
        key("thickness",
            Reals{0.0, 3000.0},
            "thickness of the soap film in the middle of a bubble (mean over bubbles), nanometers",
            &ThinFilmOptions::thickness)
            .in("nanometers"),
        key("variation",
            Reals{0.0, 2.0},
            "width of the range of thicknesses among bubbles, as a fraction of the thickness",
            &ThinFilmOptions::variation)
            .in("fraction of the thickness"),
        key("drainage",
            Reals{0.0, 10.0},
            "added thickness at the rim of a bubble, as a fraction of the thickness",
            &ThinFilmOptions::drainage)
            .in("fraction of the thickness"),
        key("gravity",
            Reals{0.0, 10.0},
            "added thickness at the bottom of a bubble, and removed thickness at its top, as a "
            "fraction of the thickness",
            &ThinFilmOptions::gravity)
            .in("fraction of the thickness"),
        key("swirl",
            Reals{0.0, 10.0},
            "amplitude of swirls in the thickness, as a fraction of the thickness",
            &ThinFilmOptions::swirl)
            .in("fraction of the thickness"),
        key("exposure",
            Reals{0.0, 100.0},
            "factor on the reflected light; a soap film reflects at most 8 % of the light",
            &ThinFilmOptions::exposure)};
}

ColorPixels draw_thin_film(FrameLayers& layers,
                           const ThinFilmOptions& options,
                           const AlbedoOptions& albedo) {
    const Films films = films_of(layers, options);
    const DistanceField& field = layers.distance();
    const Image<float> image = options.swirl > 0.0 ? thicknesses<true>(field, films, options)
                                                   : thicknesses<false>(field, films, options);
    ColorPixels colors{Image<std::uint16_t>(layers.grid().width, layers.grid().height, 3)};
    write_colors(image, colors_of_thicknesses(options.exposure), colors.pixels);
    if (layers.is_patch()) {
        paint_surroundings(layers, to_linear(parse_color(albedo.film_color)), colors.pixels);
    }
    return paint_films(layers, albedo, std::move(colors));
}

}  // namespace foam::texgen
