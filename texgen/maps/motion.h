// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/maps/map.h"

#include <string>

namespace foam::texgen {

inline constexpr MapTraits kMotionMap = {
    .name = "motion",
    .meaning = "motion vector of every point, to the next frame",
    .unit =
        "fractions of the image width, or pixels; PNG: 0.5 is no motion, 1 is motion.multiplier",
    .channels = "X Y",
    .png_bits = 16,
    .png_filter = PngFilter::Up,
    .needs_next = true};

/// The unit of a motion map. A PNG is the same for both.
enum class MotionUnit {
    Image,   // fractions of the image's width
    Pixels,  // pixels, which compositing programs expect
};

/// The direction in which the second channel is positive.
enum class MotionY { Up, Down };

struct MotionOptions {
    MotionUnit unit = MotionUnit::Image;
    MotionY y = MotionY::Up;
    // The motion that a PNG stores as its largest code, as a fraction of the image width, which
    // game engines expect. Code 0 is its negative.
    double multiplier = 0.005;
};

Keys<MotionOptions> motion_keys();

/// Draws the displacement of every point of the foam until the next frame. The motion of junctions
/// is exact. Along a film it is interpolated linearly between the two junctions, and inside a
/// bubble smoothly between the points of its films. The image has two channels: motion to the
/// right, and motion up or down. It is 0 around a patch. On a torus whose shear changes, a bubble
/// moves like the copy of it that begins at its first junction, even where the image shows a copy
/// one period above or below. Throws std::invalid_argument if there is no next frame.
NumberPixels draw_motion(FrameLayers& layers, const MotionOptions& options);

/// Returns a text for files, such as "y up; the largest code of a PNG is 0.005 of the image width".
std::string note_on_motion(const MotionOptions& options);

}  // namespace foam::texgen
