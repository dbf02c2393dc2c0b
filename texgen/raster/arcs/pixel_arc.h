#pragma once

#include "core/geometry/film_arc.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A FilmArc in pixels, with the cosine and the sine of its half angle in place of the angle.
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

/// Returns the same arc, traversed from head to tail.
inline PixelArc reversed(const PixelArc& arc) {
    return {-arc.chord, arc.cosine, -arc.sine};
}

/// Closed loops of arcs in pixels, each with the region that it bounds on its left.
struct ArcLoops {
    struct Arc {
        Vec2 tail{0.0, 0.0};
        PixelArc arc;  // ends where the next arc of the loop begins
    };
    std::vector<Arc> arcs;
    std::vector<std::size_t> loop_ends;  // one past the last arc of each loop
    int open_ends = 0;                   // pieces without a successor; 0 for a valid bubble
};

}  // namespace foam::texgen
