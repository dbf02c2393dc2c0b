#pragma once

#include "core/geometry/film_arc.h"

#include <cmath>

namespace foam::texgen {

/// A FilmArc by the cosine and the sine of its half angle, which all that is drawn is made from.
struct PixelArc {
    Vec2 chord{0.0, 0.0};  // head minus tail, pixels
    double cosine = 1.0;
    double sine = 0.0;
};

inline PixelArc pixel_arc(const FilmArc& arc) {
    return {arc.chord, std::cos(arc.half_angle), std::sin(arc.half_angle)};
}
inline FilmArc film_arc(const PixelArc& arc) {
    return {arc.chord, std::atan2(arc.sine, arc.cosine)};
}

/// The same arc walked from head to tail.
inline PixelArc reversed(const PixelArc& arc) {
    return {-arc.chord, arc.cosine, -arc.sine};
}

}  // namespace foam::texgen
