#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

struct ThinFilmOptions {
    double thickness = 350.0;  // nanometres, in the middle of a mean bubble
    double variation = 0.6;    // bubbles differ by up to this part of it, each for life
    double drainage = 0.5;     // a film is thicker by this part at the bubble's rim, where liquid
                               // gathers
    double exposure = 8.0;     // factor on the light; a soap film reflects at most 8 % of it
};

/// The part of white light of normal incidence that a soap film in air reflects, as light: Airy's
/// sum over all reflections in a layer of index 1.33, times the CIE 1931 colour matching functions
/// (Wyman, Sloan, Shirley, "Simple analytic approximations to the CIE XYZ color matching
/// functions", 2013), so that what reflects all is white. It may lie beyond sRGB: components may be
/// negative.
LinearRgb film_reflectance(double nanometres);

/// Bubbles in the interference colours of a soap film across them, with the films between them as
/// in albedo. The thickness belongs to the bubble and to the place in it, and so stands still while
/// the foam does. Colours beyond sRGB are mixed with grey of the same luminance. Transparent around
/// a patch.
ColorPixels draw_thin_film(FrameLayers& layers,
                           const ThinFilmOptions& options,
                           const AlbedoOptions& albedo);

}  // namespace foam::texgen
