#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/outlines.h"

#include <cstdint>
#include <string>

namespace foam::texgen {

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

/// Three for a torus: red, green, blue; four for a patch, with an opacity.
int albedo_channels(const Frame& frame);

/// The whole width of a film in pixels.
/// Throws std::invalid_argument as pixels_per_unit does.
double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Torus& torus);

/// Writes the colours of a frame's cells and films: sRGB in albedo_channels. Where a pixel is
/// shared, colours are mixed as light, by exact area. What is around a patch is transparent: the
/// opacity is the part of a pixel that the patch covers, its outer films to half their width
/// outwards. Colours are not premultiplied, and where there is no opacity they are those of the
/// opaque pixels around (bleed_colors). `cells` are the outlines of the frame for
/// film_width_in_pixels. The same bits for any number of threads. Throws std::invalid_argument for
/// a colour map or a colour that is not known, unless pressure_low < pressure_high, or as
/// fill_cells does.
void write_albedo(const Frame& frame,
                  const CellOutlines& cells,
                  const AlbedoOptions& options,
                  int threads,
                  ImageView<std::uint8_t> image);

/// The same as an image of its own, from outlines of its own. Throws as outline_cells does, too.
Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads);

}  // namespace foam::texgen
