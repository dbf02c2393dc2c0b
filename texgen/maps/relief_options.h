// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/mean_bubble.h"
#include "texgen/maps/relief_section.h"

#include <string_view>

namespace foam::texgen {

/// The films from which the relief rises.
enum class ReliefFilms {
    All,
    Walls,  // the walls of the maze (MazeOptions); not allowed with ReliefProfile::Dome
};

/// The options of the relief, the surface that the maps `height`, `normal`, `occlusion`,
/// `curvature`, `lit` and `caustics` show.
struct ReliefOptions {
    ReliefProfile profile = ReliefProfile::Dome;
    ReliefFilms films = ReliefFilms::All;
    double angle = 50.0;    // slope angle of domes at films, degrees
    double width = 0.2;     // distance from a film to the foot of its ridge, or radius of Plateau
                            // borders; in diameters of the mean bubble; not used by domes
    double strength = 1.0;  // factor on heights
    // Height of the grain (grain.h) in diameters of the mean bubble, before the factor `strength`;
    // 0 draws no grain. With ReliefFilms::Walls there is no grain.
    double grain = 0.0;
    // The size of the largest features of the grain, in diameters of a mean bubble of the seeded
    // foam.
    double grain_size = 0.4;
    MeanBubble mean_bubble = MeanBubble::Current;  // its diameter is the unit of heights and widths
};

/// The name of the unit of keys that are lengths on the relief: the diameter of the relief's mean
/// bubble.
inline constexpr std::string_view kReliefDiameters =
    "mean bubble diameters, selected by relief.mean_bubble";

Keys<ReliefOptions> relief_keys();

}  // namespace foam::texgen
