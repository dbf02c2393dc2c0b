#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/maps/map_image.h"
#include "texgen/raster/raster_grid.h"

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

/// What the width of a film is measured in.
enum class WidthUnit {
    Pixels,
    Diameters,  // of a circle of the seeded mean bubble area
};

/// How cells and films are coloured.
struct AlbedoOptions {
    std::string colormap = "viridis";
    double pressure_low = -0.5;  // the pressure at the colour map's start ...
    double pressure_high =
        0.5;  // ... and at its end; fixed over a sequence, so that it does not flicker
    PressureUnit pressure_unit = PressureUnit::Current;
    std::string film_color = "#ffffff";  // sRGB
    double film_width = 2.0;             // whole width, both sides of the arc; 0 draws no films
    WidthUnit film_unit = WidthUnit::Pixels;
};

/// Of every bubble in the network and then of every lone one, in the unit.
std::vector<double> pressures_of(const Frame& frame, PressureUnit unit);

/// The whole width of a film in pixels.
/// Throws std::invalid_argument as pixels_per_unit does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Torus& torus);

/// The colours of a frame's cells and films, as fill_colors mixes them. Throws
/// std::invalid_argument for a colour map or a colour that is not known, and unless pressure_low <
/// pressure_high.
ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options);

/// The same as an sRGB image, from outlines of its own. The same bits for any number of threads.
/// Throws as outline_cells does, too.
Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads);

}  // namespace foam::texgen
