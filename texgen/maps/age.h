// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/map.h"

namespace foam::texgen {

inline constexpr MapTraits kAgeMap = {
    .name = "age",
    .meaning = "time since a bubble was created, or since its neighbors changed",
    .unit = "foam time; PNG: 0 to age.full",
    .channels = "Y",
    .png_bits = 16,
    .full_key = "age.full"};

/// The moment at which a bubble's age begins.
enum class AgeSince {
    Birth,   // the birth of the bubble (FoamRecord::births)
    Change,  // the last gain or loss of a neighbor; the birth if there has been none
};

struct AgeOptions {
    AgeSince since = AgeSince::Birth;
    // The age that a PNG stores as its largest code (65535), in foam time.
    AutoReal full{50.0, true};
};

Keys<AgeOptions> age_keys();

/// Draws the age of every bubble in foam time. A pixel that several bubbles share has the mean of
/// their ages, weighted by the part of the pixel that each bubble covers. The image has one channel
/// and is 0 around a patch.
NumberPixels draw_age(FrameLayers& layers, const AgeOptions& options);

}  // namespace foam::texgen
