#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/maps/map_image.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {

class FrameLayers;

/// What a pressure is measured in before the colour map is applied.
enum class PressureUnit {
    Seed,     // film tension over the square root of the seeded mean area (that is 1)
    Current,  // film tension over the square root of this frame's mean area: contrast outlives
              // coarsening
};

/// What decides the colour of a bubble.
enum class ColorBy {
    Pressure,  // on a scale from pressure_low to pressure_high
    Area,      // the mean area of the frame is the middle of the scale: area / (area + mean)
    Sides,     // from three films at its start to nine at its end
    Random,    // anywhere on it, each bubble for life
};

/// How `colors` make a scale.
enum class ColorMix {
    Blend,  // each turns into the next
    Pick,   // only they themselves, each for an equal part of the scale
};

/// Where films end.
enum class FilmProfile {
    Even,  // as wide everywhere
    Wet,   // wider where they meet: bubbles have round corners, as liquid makes them
};

/// What the width of a film is measured in.
enum class WidthUnit {
    Pixels,
    Diameters,  // of a circle of the seeded mean bubble area
};

/// How cells and films are coloured.
struct AlbedoOptions {
    ColorBy color_by = ColorBy::Pressure;
    std::string colormap = "viridis";
    std::vector<std::string> colors{};  // sRGB, a scale of its own in place of the colour map
    ColorMix color_mix = ColorMix::Blend;
    double variation = 0.0;      // bubbles are lighter or darker by up to this part, each for life
    double pressure_low = -0.5;  // the pressure at the colour map's start ...
    double pressure_high =
        0.5;  // ... and at its end; fixed over a sequence, so that it does not flicker
    PressureUnit pressure_unit = PressureUnit::Current;
    std::string film_color = "#ffffff";  // sRGB
    double film_width = 2.0;             // whole width, both sides of the arc; 0 draws no films
    WidthUnit film_unit = WidthUnit::Pixels;
    FilmProfile film_profile = FilmProfile::Even;
    std::string shade_color = "#000000";  // sRGB; what bubbles turn to beside films ...
    double shade_width = 0.3;  // ... within so many diameters of a seeded mean bubble ...
    double shade = 0.0;        // ... by at most this part
};

/// Of every bubble in the network and then of every lone one, in the unit.
std::vector<double> pressures_of(const Frame& frame, PressureUnit unit);

/// A length in diameters of a circle of the seeded mean bubble area, in pixels. Throws
/// std::invalid_argument as pixels_per_unit does.
double diameters_in_pixels(double diameters, const RasterGrid& grid, const Domain& domain);

/// The whole width of a film in pixels.
/// Throws std::invalid_argument as pixels_per_unit does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Domain& domain);

/// The colours of a frame's cells and films: as fill_colors mixes them, or with wet films and
/// shades as paint_films does. Throws as cell_colors, and std::invalid_argument for the colour of
/// films.
ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options);

/// The same as an sRGB image, from outlines of its own. The same bits for any number of threads.
/// Throws as outline_cells does, too.
Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads);

}  // namespace foam::texgen
