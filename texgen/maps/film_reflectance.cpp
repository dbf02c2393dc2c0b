// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film_reflectance.h"

#include "core/geometry/elementary.h"

#include <array>
#include <cstddef>
#include <numbers>

namespace foam::texgen {

namespace {

// The reflectance of a layer is Airy's sum over all reflections, at normal incidence. It is
// integrated over the visible spectrum with the CIE 1931 color matching functions. These functions
// are computed in the multi-lobe approximation of Wyman, Sloan and Shirley ("Simple analytic
// approximations to the CIE XYZ color matching functions", 2013). The result is converted to linear
// sRGB and divided by the color of a perfect mirror.

constexpr double kIndexOfSoap = 1.33;       // refractive index of soapy water
constexpr double kFirstWavelength = 380.0;  // shortest wavelength, nanometers
constexpr double kWavelengthStep = 5.0;     // nanometers
constexpr int kWavelengths = 81;            // number of wavelengths, up to 780 nanometers

double wavelength_at(int k) {
    return kFirstWavelength + kWavelengthStep * k;
}

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

// Returns the values of the CIE 1931 color matching functions at a wavelength in nanometers, in the
// approximation of Wyman, Sloan and Shirley (2013).
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
    const double amplitude = (kIndexOfSoap - 1.0) / (kIndexOfSoap + 1.0);
    const double one_surface = amplitude * amplitude;  // reflectance of one surface of the film
    const double half_phase = 2.0 * std::numbers::pi * kIndexOfSoap * thickness / wavelength;
    const double sine = ieee::sin(half_phase);
    const double interference = 4.0 * one_surface * sine * sine;
    return interference / ((1.0 - one_surface) * (1.0 - one_surface) + interference);
}

// Returns the color of a spectrum in linear sRGB, not yet divided by the color of a perfect mirror.
// spectrum(wavelength) returns a fraction from 0 to 1 for a wavelength in nanometers.
template <class Spectrum>
LinearRgb spectrum_to_rgb(const Spectrum& spectrum) {
    static const std::array<Xyz, kWavelengths> matching = [] {
        std::array<Xyz, kWavelengths> all;
        for (int k = 0; k < kWavelengths; ++k) {
            all[static_cast<std::size_t>(k)] = color_matching(wavelength_at(k));
        }
        return all;
    }();
    Xyz sum;
    for (int k = 0; k < kWavelengths; ++k) {
        const double value = spectrum(wavelength_at(k));
        const Xyz& weights = matching[static_cast<std::size_t>(k)];
        sum.x += value * weights.x;
        sum.y += value * weights.y;
        sum.z += value * weights.z;
    }
    return to_rgb(sum);
}

}  // namespace

LinearRgb film_reflectance(double nanometers) {
    const LinearRgb white = spectrum_to_rgb([](double) { return 1.0; });
    const LinearRgb color =
        spectrum_to_rgb([&](double wavelength) { return reflectance(nanometers, wavelength); });
    return {color.r / white.r, color.g / white.g, color.b / white.b};
}

}  // namespace foam::texgen
