// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/maps/map.h"

#include <string>

namespace foam::texgen {

inline constexpr MapTraits kPressureMap = {
    .name = "pressure",
    .meaning = "pressure of bubbles, with the same scale in all frames",
    .unit = "0 to 1",
    .channels = "Y",
    .png_bits = 16};

/// The scale that turns pressures into numbers from 0 to 1.
enum class PressureScaling {
    Range,       // from a lowest to a highest pressure
    Percentile,  // from a low to a high percentile of the first frame's bubbles
    Rank,        // the fraction of the first frame's bubbles with a lower pressure, which gives
                 // every tone the same number of bubbles
};

/// The scale of pressures, which is the same in all frames to prevent flicker.
struct PressureOptions {
    PressureScaling scaling = PressureScaling::Percentile;
    PressureUnit unit = PressureUnit::Current;  // the unit of low and high, for Range
    double low = -0.5;
    double high = 0.5;
    double percentile = 2.0;        // percentage of bubbles left out at either end
    double exaggeration = 1.0;      // factor on the difference from the middle tone
    std::string colormap = "none";  // "none" leaves gray numbers
};

Keys<PressureOptions> pressure_keys();

/// Draws the pressures of bubbles as tones, without films. Tones are numbers or colors of a color
/// map. Pressures within the scale become numbers from 0 to 1, and pressures outside the scale
/// become numbers outside that range. If all pressures of the scale are equal, the tone is 0.5.
/// Numbers have one channel and are 0 around a patch; colors are transparent there. Throws
/// std::invalid_argument for an unknown color map, and if low is not below high.
MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options);

}  // namespace foam::texgen
