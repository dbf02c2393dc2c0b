#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

enum class DistanceKind {
    Plain,   // from the middle of the nearest film; 0 around a patch
    Signed,  // from the nearest film's edge: above 0 in bubbles, below in films and around a patch
};

enum class DistanceUnit { Pixels, Foam };

struct DistanceOptions {
    DistanceKind kind = DistanceKind::Plain;
    DistanceUnit unit = DistanceUnit::Foam;
    double full = 1.0;  // what the largest code of a PNG stands for, in the unit; where signed, the
                        // smallest for its negative
};

/// Distances to the nearest film, exact from its arc, at the middle of every pixel. One channel.
/// The films' edges are those of albedo.
NumberPixels draw_distance(FrameLayers& layers,
                           const DistanceOptions& options,
                           const AlbedoOptions& films);

}  // namespace foam::texgen
