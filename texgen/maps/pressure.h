// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/maps/map.h"
#include "texgen/maps/per_bubble.h"

#include <string>

namespace foam::texgen {

inline constexpr MapTraits kPressureMap = {
    .name = "pressure",
    .meaning = "pressure of bubbles, by default with the same scale in all frames",
    .unit = "0 to 1",
    .channels = "Y",
    .png_bits = 16};

/// The traits of the map if PressureOptions::colormap is set.
inline constexpr MapTraits kColoredPressureMap = {.name = kPressureMap.name,
                                                  .meaning = kPressureMap.meaning,
                                                  .unit = "light",
                                                  .channels = "R G B",
                                                  .kind = MapKind::Color};

/// The scale that converts pressures to tones. Its ends have the tones 0 and 1. Percentiles and
/// ranks are measured among the pressures at the end of the warm-up before frame 1
/// (FoamRecord::first_pressures), so that all frames have the same scale. If pressures are smoothed
/// or flattened, percentiles and ranks are measured among the resulting pressures of the frame.
enum class PressureScaling {
    Range,       // from PressureOptions::low to PressureOptions::high
    Percentile,  // from a low to a high percentile of the pressures
    Rank,        // the rank among the pressures, which spreads the bubbles evenly over all tones
    Share,       // the total area of the bubbles of lower pressure, divided by the area of all
                 // bubbles of the frame, which spreads the area evenly over all tones
};

/// The options of the map.
struct PressureOptions {
    PressureScaling scaling = PressureScaling::Percentile;
    PressureUnit unit = PressureUnit::Current;  // the unit of low and high, for Range
    double low = -0.5;                          // pressure of tone 0, for Range
    double high = 0.5;                          // pressure of tone 1, for Range
    double percentile = 2.0;  // for Percentile: percentage of bubbles beyond each end of the scale
    int smoothing = 0;        // rounds of averaging with neighbors (average_with_neighbors)
    // Further rounds of averaging, after the rounds of `smoothing`. They give a wider average,
    // which is subtracted from the smoothed pressures. With 0 rounds, nothing is subtracted.
    int flattening = 0;
    double exaggeration = 1.0;      // factor on the difference from the middle tone, 0.5
    std::string colormap = "none";  // "none" draws the tones as numbers
};

Keys<PressureOptions> pressure_keys();

/// Returns kColoredPressureMap if a color map is set, otherwise kPressureMap.
const MapTraits& pressure_traits(const PressureOptions& options);

/// Returns options with which the map is drawn as numbers.
PressureOptions without_colors(PressureOptions options);

/// Returns the tone of every bubble: the position of its pressure on the scale, with its difference
/// from 0.5 multiplied by options.exaggeration. With the scaling Percentile, all tones are 0.5 if
/// both percentiles are equal. All tones are also 0.5 if percentiles or ranks of
/// FoamRecord::first_pressures are needed, but this list is empty. Throws std::invalid_argument if
/// options.low is not below options.high, even if the scaling is not Range.
PerBubble<double> pressure_tones(const FrameLayers& layers, const PressureOptions& options);

/// Draws every bubble in its tone, as a number or as a color of a color map (pressure_traits).
/// Films are not drawn. Numbers may be outside the range from 0 to 1; colors are clamped to the
/// ends of the color map. Numbers have one channel and are 0 around a patch; colors are transparent
/// there. Throws as pressure_tones does, and std::invalid_argument for an unknown color map.
MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options);

}  // namespace foam::texgen
