// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
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
    .png_filter = PngFilter::Up,
    .needs_distance = true,
    .full_key = "distance.full"};

/// Selects the line of a film from which distances are measured, and the sign of distances.
enum class DistanceKind {
    Plain,   // from the center line of the nearest film; 0 around a patch
    Signed,  // from the film's edge on the side of the bubble; negative in films and around a patch
};

/// The unit of distances: pixels or foam units.
enum class DistanceUnit { Pixels, Foam };

struct DistanceOptions {
    DistanceKind kind = DistanceKind::Plain;
    DistanceUnit unit = DistanceUnit::Foam;
    // The distance that a PNG stores as its largest code (65535), in the unit `unit`. Code 0 stands
    // for 0, or for -full if distances are signed.
    AutoReal full{1.0, true};
};

Keys<DistanceOptions> distance_keys();

/// Draws the distance from the center of every pixel to the nearest film, computed from the film's
/// exact arc. In a cross-fade, the rims of growing bubbles count as films, and distances from them
/// are approximate (FadeBorder). Signed distances use the film width of the map albedo; wet films
/// count as films that have this width everywhere. The image has one channel. If no bubble is left
/// in a patch, plain distances are 0 and signed distances are -options.full.
NumberPixels draw_distance(FrameLayers& layers,
                           const DistanceOptions& options,
                           const AlbedoOptions& films);

}  // namespace foam::texgen
