// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/thin_film.h"

#include "core/foam/measure.h"
#include "core/geometry/elementary.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/identity_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace foam::texgen {

namespace {

// The reflectance of a layer is Airy's sum over all reflections, at normal incidence. It is
// integrated over the visible spectrum with the CIE 1931 color matching functions, in the
// multi-lobe approximation of Wyman, Sloan and Shirley ("Simple analytic approximations to the CIE
// XYZ color matching functions", 2013). The result is converted to linear sRGB and divided by the
// color of a perfect mirror. A table contains the color for every nanometer of thickness.
//
// The thickness of the soap film that spans a bubble depends on the position in the bubble: liquid
// gathers at the rim and at the bottom, and swirls. In this file, the place of a point is its
// position in the bubble, as a vector that is zero in the middle of the bubble and has length 1 at
// its rim: the negative gradient of the smooth distance (raster/distance/distance_field.h). In a
// circle of radius R, this is the position relative to the center, divided by R.

constexpr double kIndex = 1.33;             // refractive index of soapy water
constexpr double kFirstWavelength = 380.0;  // shortest wavelength, nanometers
constexpr double kWavelengthStep = 5.0;     // nanometers
constexpr int kWavelengths = 81;            // number of wavelengths, up to 780 nanometers
constexpr int kThickest = 4000;             // nanometers; thicker films are practically gray

struct Xyz {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};

// Returns the value of a Gaussian curve at a wavelength. Its extreme value, at the wavelength
// `middle`, is `height`. Its standard deviation is `below` at shorter wavelengths and `above` at
// longer ones. Wavelengths are in nanometers.
double lobe(double wavelength, double height, double middle, double below, double above) {
    const double t = (wavelength - middle) / (wavelength < middle ? below : above);
    return height * ieee::exp(-0.5 * t * t);
}

// Returns the CIE 1931 color matching functions at a wavelength in nanometers, by Wyman, Sloan and
// Shirley (2013).
Xyz color_matching(double wavelength) {
    return {
        lobe(wavelength, 1.056, 599.8, 37.9, 31.0) + lobe(wavelength, 0.362, 442.0, 16.0, 26.7) +
            lobe(wavelength, -0.065, 501.1, 20.4, 26.2),
        lobe(wavelength, 0.821, 568.8, 46.9, 40.5) + lobe(wavelength, 0.286, 530.9, 16.3, 31.1),
        lobe(wavelength, 1.217, 437.0, 11.8, 36.0) + lobe(wavelength, 0.681, 459.0, 26.0, 13.8)};
}

// Converts CIE XYZ to linear sRGB.
LinearRgb to_rgb(const Xyz& c) {
    return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
            -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
            0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

// Returns the fraction of light of one wavelength that a film reflects (Airy's sum). Thickness and
// wavelength are in nanometers.
double reflectance(double thickness, double wavelength) {
    const double at_surface = (kIndex - 1.0) / (kIndex + 1.0);
    const double once = at_surface * at_surface;
    const double half_phase = 2.0 * std::numbers::pi * kIndex * thickness / wavelength;
    const double sine = ieee::sin(half_phase);
    const double interference = 4.0 * once * sine * sine;
    return interference / ((1.0 - once) * (1.0 - once) + interference);
}

// Returns the color of a spectrum in linear sRGB, not yet divided by the color of a perfect mirror.
// spectrum(wavelength) returns a fraction from 0 to 1 for a wavelength in nanometers.
template <class Spectrum>
LinearRgb spectrum_to_rgb(const Spectrum& spectrum) {
    Xyz sum;
    for (int k = 0; k < kWavelengths; ++k) {
        const double wavelength = kFirstWavelength + kWavelengthStep * k;
        const Xyz matching = color_matching(wavelength);
        const double value = spectrum(wavelength);
        sum.x += value * matching.x;
        sum.y += value * matching.y;
        sum.z += value * matching.z;
    }
    return to_rgb(sum);
}

// Returns film_reflectance for every whole number of nanometers from 0 to kThickest.
std::vector<LinearRgb> make_reflectances() {
    std::vector<LinearRgb> all;
    for (int thickness = 0; thickness <= kThickest; ++thickness) {
        all.push_back(film_reflectance(thickness));
    }
    return all;
}

// Returns film_reflectance(thickness), interpolated in a table. `thickness` is in nanometers.
LinearRgb reflectance_from_table(double thickness) {
    static const std::vector<LinearRgb> table = make_reflectances();
    const double position = std::clamp(thickness, 0.0, static_cast<double>(kThickest));
    const std::size_t below = std::min(static_cast<std::size_t>(position), table.size() - 2);
    const double part = position - static_cast<double>(below);
    return mixed(table[below], table[below + 1], part);
}

// Returns a color whose components are from 0 to 1: the given color, mixed with as little gray of
// the same luminance as possible.
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

// The soap film that spans a bubble.
struct Film {
    double thickness = 0.0;  // nanometers, in the middle
    double radius = 0.0;     // of a circle with the bubble's area, in pixels; 0 around a patch
    double phase = 0.0;      // of the swirls, radians
};

// Returns the soap films of all bubbles, indexed by the ids of the distance field.
std::vector<Film> films_of(FrameLayers& layers, const ThinFilmOptions& options) {
    const Frame& frame = layers.frame();
    const double scale = pixels_per_unit(layers.grid(), frame.domain);
    const auto thickness_of = [&](BubbleIdentity bubble) {
        const double number = identity_number(bubble, IdentityStream::Second) - 0.5;
        return options.thickness * (1.0 + options.variation * number);
    };
    const auto film_of = [&](BubbleIdentity bubble, double radius) {
        const double number = identity_number(bubble, IdentityStream::First);
        return Film{thickness_of(bubble), scale * radius, 2.0 * std::numbers::pi * number};
    };
    const auto films = per_bubble<Film>(
        frame,
        [&](BubbleId bubble) {
            const FrameBubble& one = frame.bubbles[bubble];
            return film_of(one.identity, std::sqrt(one.area / std::numbers::pi));
        },
        [&](const LoneBubble& bubble) { return film_of(bubble.identity, lone_radius(bubble)); });
    return by_cell_id(layers, films, Film{});
}

// Returns a number from -1 to 1 that varies smoothly over a bubble: the sum of two crossed waves,
// one of which bends the other. The pattern is twisted about the middle of the bubble, so that the
// waves wind around it. `phase` turns the pattern and shifts the waves, so that bubbles differ.
double swirl_at(const Vec2& place, double phase) {
    constexpr double kTwist = 2.2;  // angle between the middle and the rim, radians
    const double angle = phase + kTwist * place.squaredNorm();
    const auto [sine, cosine] = ieee::sincos(angle);
    const Vec2 at(cosine * place.x() - sine * place.y(), sine * place.x() + cosine * place.y());
    const double across = ieee::sin(2.5 * at.y() + 3.0 * phase);
    return 0.65 * ieee::sin(4.0 * at.x() + 1.5 * across + phase) + 0.35 * across;
}

// Returns the thickness in nanometers at a place (see the top of this file) with the given smooth
// distance, in pixels, from the rim. The variable `rim` is 1 at the rim and 0 in the middle,
// because in the middle of a circle of radius R the smooth distance is R / 2.
double thickness_at(const Film& film,
                    double smooth,
                    const Vec2& place,
                    const ThinFilmOptions& options) {
    const double rim = 1.0 - std::min(2.0 * smooth / film.radius, 1.0);
    double factor = 1.0 + options.drainage * rim * rim - options.gravity * place.y();
    if (options.swirl > 0.0) {
        factor += options.swirl * swirl_at(place, film.phase);
    }
    return film.thickness * std::max(factor, 0.0);
}

// The interference colors of bubbles at the centers of pixels.
class FilmColors {
  public:
    FilmColors(FrameLayers& layers, const ThinFilmOptions& options)
        : options_(options), field_(layers.distance()), films_(films_of(layers, options)) {}

    // Returns the color at the pixel with the given index, or nullopt around a patch.
    std::optional<LinearRgb> at(std::size_t index) const {
        const Film& film = films_[field_.ids.samples()[index]];
        if (!(film.radius > 0.0)) {
            return std::nullopt;
        }
        const auto smooth = static_cast<double>(field_.smooth.samples()[index]);
        const auto gradient = field_.smooth_gradient.samples().subspan(2 * index, 2);
        const Vec2 place(-gradient[0], -gradient[1]);
        const LinearRgb light = reflectance_from_table(thickness_at(film, smooth, place, options_));
        const double exposure = options_.exposure;
        return within_srgb({exposure * light.r, exposure * light.g, exposure * light.b});
    }

  private:
    const ThinFilmOptions& options_;
    const DistanceField& field_;
    std::vector<Film> films_;
};

}  // namespace

Keys<ThinFilmOptions> thin_film_keys() {
    return {
        key("thickness",
            Reals{0.0, 3000.0},
            "thickness of the soap film in the middle of a bubble, mean over bubbles, nanometers",
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

LinearRgb film_reflectance(double nanometers) {
    const LinearRgb white = spectrum_to_rgb([](double) { return 1.0; });
    const LinearRgb color =
        spectrum_to_rgb([&](double wavelength) { return reflectance(nanometers, wavelength); });
    return {color.r / white.r, color.g / white.g, color.b / white.b};
}

ColorPixels draw_thin_film(FrameLayers& layers,
                           const ThinFilmOptions& options,
                           const AlbedoOptions& albedo) {
    const LinearRgb line = to_linear(parse_color(albedo.film_color));
    const FilmColors films(layers, options);
    return paint_films(layers, albedo, [&](std::size_t k) { return films.at(k).value_or(line); });
}

}  // namespace foam::texgen
