// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/keys/key.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/raster/coords/raster_grid.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The property of a bubble that decides its color.
enum class ColorBy {
    Pressure,  // the scale goes from pressure_low to pressure_high
    Area,      // area / (area + mean): the mean area of the frame is the middle of the scale
    Sides,     // the scale goes from three films to nine films
    Random,    // a pseudo-random position on the scale, which a bubble keeps for life
};

/// The conversion of the list `colors` to a scale.
enum class ColorMix {
    Blend,  // interpolated from each color to the next
    Pick,   // not interpolated; each color covers an equal part of the scale
};

/// The shape of films.
enum class FilmProfile {
    Even,  // the same width everywhere
    Wet,   // wider where films meet, which gives bubbles the round corners of wet foam
};

/// The unit of the width of films.
enum class WidthUnit {
    Pixels,
    Diameters,  // diameters of a circle that has the seeded mean bubble area
};

/// The colors of bubbles, and the width and shape of films in all maps.
struct AlbedoOptions {
    ColorBy color_by = ColorBy::Pressure;
    std::string colormap = "viridis";
    std::vector<std::string> colors{};  // sRGB; replaces the color map unless empty
    ColorMix color_mix = ColorMix::Blend;
    double variation = 0.0;  // largest relative change of brightness, constant for a bubble's life
    double pressure_low = -0.5;  // pressure at the start of the scale, the same in all frames
    double pressure_high = 0.5;  // pressure at the end of the scale, the same in all frames
    PressureUnit pressure_unit = PressureUnit::Current;
    std::string film_color = "#ffffff";  // sRGB
    double film_width = 2.0;  // full width of a film, centered on its arc; 0 draws no films
    WidthUnit film_unit = WidthUnit::Pixels;
    FilmProfile film_profile = FilmProfile::Even;
    std::string shade_color = "#000000";  // sRGB; mixed into bubbles beside films
    double shade_width = 0.3;  // width of the shade, in diameters of a seeded mean bubble
    double shade = 0.0;        // weight of the shade's color at films; 0 draws no shade
};

Keys<AlbedoOptions> albedo_keys();

/// Converts a length to pixels. The unit of `diameters` is the diameter of a circle that has the
/// seeded mean bubble area. Throws std::invalid_argument as pixels_per_unit does.
double diameters_in_pixels(double diameters, const RasterGrid& grid, const Domain& domain);

/// Returns the full width of a film in pixels. Throws std::invalid_argument as pixels_per_unit
/// does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Domain& domain);

}  // namespace foam::texgen
