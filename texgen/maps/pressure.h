#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

#include <string>

namespace foam::texgen {

class FrameLayers;

/// What a pressure becomes a number from 0 to 1 by.
enum class PressureScaling {
    Range,       // from a lowest to a highest pressure
    Percentile,  // the same, with ends that leave out a percentage of the first frame's bubbles
    Rank,        // the share of the first frame's bubbles with a lower pressure: as many of each
                 // tone
};

/// The scale of all three is the same in all frames, so that none flickers.
struct PressureOptions {
    PressureScaling scaling = PressureScaling::Percentile;
    PressureUnit unit = PressureUnit::Current;  // of low and high
    double low = -0.5;
    double high = 0.5;
    double percentile = 2.0;        // left out at either end
    double exaggeration = 1.0;      // of what differs from the middle tone
    std::string colormap = "none";  // grey numbers
};

/// The pressures of bubbles as tones, without films: numbers from 0 to 1, beyond where pressures
/// are beyond the scale, or colours of a colour map. One channel; 0 around a patch, where colours
/// are transparent. Where all pressures of the scale are one, the tone is 0.5. Throws
/// std::invalid_argument for a colour map that is not known and unless low < high.
MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options);

}  // namespace foam::texgen
