// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"

namespace foam::texgen {

/// Returns the color of the light that a soap film in air reflects if white light falls on it
/// perpendicularly. The result is linear light. `nanometers` is the thickness of the film. The
/// reflectance at each wavelength is Airy's sum over all reflections in a layer of refractive index
/// 1.33. The reflectance is weighted with the CIE 1931 color matching functions, and scaled so that
/// a perfect mirror is white. The color matching functions are the approximations of Wyman, Sloan
/// and Shirley ("Simple analytic approximations to the CIE XYZ color matching functions", 2013).
/// The color may be outside sRGB: components may be negative.
LinearRgb film_reflectance(double nanometers);

}  // namespace foam::texgen
