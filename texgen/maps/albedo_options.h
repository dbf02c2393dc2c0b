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
    Pressure,  // on a scale from pressure_low to pressure_high
    Area,      // area / (area + mean): the mean area of the frame is the middle of the scale
    Sides,     // from three films at the start of the scale to nine at its end
    Random,    // anywhere on the scale, each bubble for life
};

/// How `colors` make a scale.
enum class ColorMix {
    Blend,  // each turns into the next
    Pick,   // only the colors themselves, each for an equal part of the scale
};

/// The shape of films.
enum class FilmProfile {
    Even,  // the same width everywhere
    Wet,   // wider where films meet, which gives bubbles the round corners of wet foam
};

/// The unit of the width of films.
enum class WidthUnit {
    Pixels,
    Diameters,  // of a circle of the seeded mean bubble area
};

/// The colors of bubbles, and the width and shape of films in all maps.
struct AlbedoOptions {
    ColorBy color_by = ColorBy::Pressure;
    std::string colormap = "viridis";
    std::vector<std::string> colors{};  // sRGB; if not empty, a scale that replaces the color map
    ColorMix color_mix = ColorMix::Blend;
    double variation = 0.0;      // bubbles are lighter or darker by up to this fraction, for life
    double pressure_low = -0.5;  // the pressure at the start of the scale ...
    double pressure_high = 0.5;  // ... and at its end; the same in all frames, without flicker
    PressureUnit pressure_unit = PressureUnit::Current;
    std::string film_color = "#ffffff";  // sRGB
    double film_width = 2.0;             // of both sides of the arc together; 0 draws no films
    WidthUnit film_unit = WidthUnit::Pixels;
    FilmProfile film_profile = FilmProfile::Even;
    std::string shade_color = "#000000";  // sRGB; bubbles turn to it beside films ...
    double shade_width = 0.3;  // ... within this distance, in diameters of a seeded mean bubble ...
    double shade = 0.0;        // ... by at most this fraction
};

Keys<AlbedoOptions> albedo_keys();

/// Returns a length, given in diameters of a circle of the seeded mean bubble area, in pixels.
/// Throws std::invalid_argument as pixels_per_unit does.
double diameters_in_pixels(double diameters, const RasterGrid& grid, const Domain& domain);

/// Returns the whole width of a film in pixels. Throws std::invalid_argument as pixels_per_unit
/// does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Domain& domain);

}  // namespace foam::texgen
