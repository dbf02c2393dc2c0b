// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kDistanceMap = {
    .name = "distance",
    .meaning = "distance to the nearest film, plain or signed",
    .unit =
        "foam units or pixels; PNG: 0 to distance.full, or -distance.full to distance.full if "
        "signed",
    .channels = "Y",
    .png_bits = 16,
    .png_filter = PngFilter::Up};

enum class DistanceKind {
    Plain,   // from the center line of the nearest film; 0 around a patch
    Signed,  // from the edge of the nearest film; negative in films and around a patch
};

enum class DistanceUnit { Pixels, Foam };

struct DistanceOptions {
    DistanceKind kind = DistanceKind::Plain;
    DistanceUnit unit = DistanceUnit::Foam;
    double full = 1.0;  // distance stored as the largest code of a PNG, in this unit; if signed,
                        // code 0 is its negative
};

Keys<DistanceOptions> distance_keys();

/// Draws the distance from the center of every pixel to the nearest film, computed from the film's
/// exact arc. Signed distances use the film width of albedo. The image has one channel.
NumberPixels draw_distance(FrameLayers& layers,
                           const DistanceOptions& options,
                           const AlbedoOptions& films);

}  // namespace foam::texgen
