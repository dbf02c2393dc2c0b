// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value_kinds.h"
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
    .needs_next = true,
    .full_key = "motion.multiplier"};

/// The unit of both channels of a motion map. A PNG is the same for both units.
enum class MotionUnit {
    Image,   // fractions of the image's width
    Pixels,  // pixels, which compositing programs expect
};

/// The direction in which the second channel is positive.
enum class MotionY { Up, Down };

struct MotionOptions {
    MotionUnit unit = MotionUnit::Image;
    MotionY y = MotionY::Up;
    // The motion that the largest code (integer sample) of a PNG stands for, as a fraction of the
    // image width. Code 0 stands for the opposite motion. A program that plays the PNGs needs this
    // number to convert codes to motion.
    AutoReal multiplier{0.005, true};
};

Keys<MotionOptions> motion_keys();

/// Draws the displacement of every point of the foam until the next frame. Junctions have the
/// motion that junction_motion returns. Along a film the motion is interpolated linearly between
/// its two junctions, and inside a bubble smoothly between the points of its films. A lone bubble
/// moves and grows as a circle; its motion is 0 if it is not a lone bubble in the next frame. The
/// image has two channels: motion to the right, and motion up or down (options.y). Around a patch,
/// both are 0.
///
/// A bubble of a torus has periodic copies. If the shear of the torus changes, two copies that are
/// one period apart in y have different motions. All copies are drawn with the motion of one of
/// them: the copy whose first junction is in the fundamental cell of the torus
/// (core/geometry/domain.h). The first junction of a bubble is the tail of Network::first.
///
/// Throws std::invalid_argument if there is no next frame.
NumberPixels draw_motion(FrameLayers& layers, const MotionOptions& options);

/// Returns a text for the metadata of files, such as "y up; the largest code of a PNG stands for a
/// motion of 0.005 of the image width".
std::string note_on_motion(const MotionOptions& options);

}  // namespace foam::texgen
