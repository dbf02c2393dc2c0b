#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/maps/map.h"

#include <string>

namespace foam::texgen {

inline constexpr MapTraits kPressureMap = {
    .name = "pressure",
    .meaning = "pressure of bubbles, scaled alike in all frames",
    .unit = "0 to 1",
    .channels = "Y",
    .png_bits = 16};

/// The scale that turns pressures into numbers from 0 to 1.
enum class PressureScaling {
    Range,       // from a lowest to a highest pressure
    Percentile,  // the same, between percentiles of the first frame's bubbles
    Rank,        // the share of the first frame's bubbles with a lower pressure, which gives every
                 // tone the same number of bubbles
};

/// The scale is the same in all frames, so that none flickers.
struct PressureOptions {
    PressureScaling scaling = PressureScaling::Percentile;
    PressureUnit unit = PressureUnit::Current;  // of low and high
    double low = -0.5;
    double high = 0.5;
    double percentile = 2.0;        // percentage of bubbles left out at either end
    double exaggeration = 1.0;      // factor on the difference from the middle tone
    std::string colormap = "none";  // "none" leaves gray numbers
};

Keys<PressureOptions> pressure_keys();

/// Draws the pressures of bubbles as tones, without films: numbers from 0 to 1, and beyond for
/// pressures beyond the scale, or colors of a color map. If all pressures of the scale are equal,
/// the tone is 0.5. One channel; 0 around a patch, where colors are transparent. Throws
/// std::invalid_argument for an unknown color map, and unless low < high.
MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options);

}  // namespace foam::texgen
