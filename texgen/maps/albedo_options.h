// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "texgen/keys/key.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/pictures/picture_file.h"
#include "texgen/raster/coords/raster_grid.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The property of a bubble that determines its position on the scale of colors.
enum class ColorBy {
    Pressure,  // the scale goes from pressure_low to pressure_high
    // The position is a / (a + m), where a is the area of the bubble and m is the mean area of all
    // bubbles. A bubble of the mean area is in the middle of the scale.
    Area,
    Sides,   // the scale goes from three sides to nine sides
    Random,  // a pseudo-random position on the scale, which a bubble keeps for life
    // There is no scale: a bubble has the mean color of the part of a picture that it covers.
    Picture,
};

/// The frame in which a bubble takes its color from a picture.
enum class PictureSampling {
    FirstFrame,  // frame 1; a bubble keeps the color for life. Bubbles that are born later take
                 // the color under them in each frame.
    EveryFrame,  // each frame: bubbles change their colors when they move
};

/// The construction of a scale of colors from the list AlbedoOptions::colors.
enum class ColorMix {
    Blend,  // interpolated from each color to the next
    // Not interpolated: each color covers the scale from its position to the position of the next
    // color. If no color has a position, each covers an equal part of the scale.
    Pick,
};

/// The shape of films.
enum class FilmProfile {
    Even,  // the same width everywhere
    Wet,   // wider where films meet, which gives bubbles the rounded corners of wet foam
};

/// The unit of the width of films.
enum class WidthUnit {
    Pixels,
    Diameters,  // diameters of a mean bubble of the seeded foam: a circle of area 1
};

/// The colors of bubbles, and the width and shape of films. The walls of mazes, the lines of the
/// map `contour`, and the relief have widths of their own.
struct AlbedoOptions {
    ColorBy color_by = ColorBy::Pressure;
    std::string colormap = "viridis";
    // sRGB, "#rrggbb" or "#rrggbb@position" (color_scale.h); if not empty, replaces the color map.
    std::vector<std::string> colors{};
    // The picture whose main colors are in `colors` (texgen/pictures/palette.h). Not set if the
    // colors do not come from a picture.
    PictureFile colors_from{};
    int colors_count = 5;  // the largest number of main colors
    ColorMix color_mix = ColorMix::Blend;
    // The largest random change of a bubble's brightness, as a fraction; a bubble keeps its change
    // for life.
    double variation = 0.0;
    PictureFile picture{};  // the picture of ColorBy::Picture
    PictureSampling picture_sampling = PictureSampling::FirstFrame;
    double pressure_low = -0.5;  // pressure at the start of the scale, the same in all frames
    double pressure_high = 0.5;  // pressure at the end of the scale, the same in all frames
    PressureUnit pressure_unit = PressureUnit::Current;  // unit of both pressures
    std::string film_color = "#ffffff";                  // sRGB
    double film_width = 2.0;  // full width of a film, centered on its arc; 0 draws no films
    WidthUnit film_unit = WidthUnit::Pixels;
    FilmProfile film_profile = FilmProfile::Even;
    std::string shade_color = "#000000";  // sRGB; mixed into bubbles beside films
    // The width of the shade on each side of a film, in diameters of a mean bubble of the seeded
    // foam.
    double shade_width = 0.3;
    // The strength of the grain (grain.h) of bubbles: the change of brightness, as a fraction,
    // rarely exceeds this number. 0 draws no grain.
    double grain = 0.0;
    // The size of the largest features of the grain, in the unit of shade_width.
    double grain_size = 0.4;
    double shade = 0.0;  // weight of the shade's color at films, 0 to 1; 0 draws no shade
};

Keys<AlbedoOptions> albedo_keys();

/// Converts a length to pixels. The unit of `diameters` is the diameter of a mean bubble of the
/// seeded foam, which is a circle of area 1. Throws std::invalid_argument if the grid and the
/// domain do not fit together (pixels_per_unit).
double diameters_in_pixels(double diameters, const RasterGrid& grid, const Domain& domain);

/// Returns options.film_width in pixels. If options.film_unit is Diameters, throws as
/// diameters_in_pixels does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Domain& domain);

}  // namespace foam::texgen
