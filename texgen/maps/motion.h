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
    Pixels,  // as compositing programs expect
};

/// The direction in which the second number is positive.
enum class MotionY { Up, Down };

struct MotionOptions {
    MotionUnit unit = MotionUnit::Image;
    MotionY y = MotionY::Up;
    // The motion at the largest code of a PNG, in fractions of the image's width, which is the form
    // that engines expect. Its negative is at code 0.
    double multiplier = 0.005;
};

Keys<MotionOptions> motion_keys();

/// Draws how far every point of the foam moves until the next frame. The motion of junctions is
/// exact. Points on films move in proportion between their junctions, and points in a bubble
/// smoothly between points on its films. Two channels: to the right, and up or down; 0 around a
/// patch. On a torus whose shear changes, the copy that is drawn in the image determines the
/// motion: copies one period up move farther. Throws std::invalid_argument without a next frame.
NumberPixels draw_motion(FrameLayers& layers, const MotionOptions& options);

/// Returns a text for files, such as "y up; the largest code of a PNG is 0.005 of the image width".
std::string note_on_motion(const MotionOptions& options);

}  // namespace foam::texgen
