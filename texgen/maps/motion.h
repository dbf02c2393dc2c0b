#pragma once

#include "texgen/maps/map_image.h"

#include <string>

namespace foam::texgen {

class FrameLayers;

/// What the numbers of a motion map are in. A PNG is the same for both.
enum class MotionUnit {
    Image,   // parts of the image's width
    Pixels,  // as compositing programs take them
};

/// Which way a positive second number points.
enum class MotionY { Up, Down };

struct MotionOptions {
    MotionUnit unit = MotionUnit::Image;
    MotionY y = MotionY::Up;
    double multiplier = 0.005;  // parts of the image's width that the ends of a PNG's codes stand
                                // for, from the middle on; engines ask for it
};

/// Where every place of the foam moves to the next frame. Junctions move as they do, places on
/// films between them in proportion, and places in a bubble smoothly between those on its films.
/// Two channels: to the right, and up or down; 0 around a patch. In a sheared torus motion is that
/// of the image's own cell: copies one period up move farther. Needs the next frame: throws
/// std::invalid_argument without.
NumberPixels draw_motion(FrameLayers& layers, const MotionOptions& options);

/// "y up; a PNG's largest code is 0.005 of the image's width".
std::string note_on_motion(const MotionOptions& options);

}  // namespace foam::texgen
