// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/indexed.h"
#include "texgen/keys/key.h"
#include "texgen/maps/map.h"
#include "texgen/maps/pressure.h"

#include <cstdint>
#include <string>

namespace foam::texgen {

inline constexpr MapTraits kContourMap = {
    .name = "contour",
    .meaning =
        "line art: the films between different levels of pressure, and the outline of a patch",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .png_filter = PngFilter::Up};

struct ContourOptions {
    std::int64_t levels = 2;  // number of equal levels into which tones are divided (draw_contour)
    // The full width of lines, in diameters of a mean bubble of the seeded foam.
    double width = 0.2;
    std::string line_color = "#16262f";  // colors are sRGB
    std::string ground_color = "#f4efe2";
};

Keys<ContourOptions> contour_keys();

/// Returns 1 for each film along which draw_contour draws a line, and 0 for all other films. Throws
/// as pressure_tones does.
Indexed<FilmId, std::uint8_t> contour_films(const FrameLayers& layers,
                                            const ContourOptions& options,
                                            const PressureOptions& pressure);

/// Draws, as lines with round ends, the films between bubbles of different levels. The tone of a
/// bubble is its pressure on the scale of the map `pressure` (pressure_tones). This scale is
/// divided into options.levels equal levels; tones beyond its ends belong to the first and the last
/// level. The outer films of a patch and lone bubbles are drawn, too. The surroundings of a patch
/// are transparent. Throws as pressure_tones does, and std::invalid_argument if a color is invalid.
ColorPixels draw_contour(FrameLayers& layers,
                         const ContourOptions& options,
                         const PressureOptions& pressure);

}  // namespace foam::texgen
