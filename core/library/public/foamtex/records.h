// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

/// The plain values of a foam at one instant. All lengths are in foam units: the mean bubble area
/// of a seeded foam is 1. x points right and y points up. The equations E1 to E11 are explained in
/// core/EQUATIONS.md.
namespace foamtex {

/// A point or a vector of the plane.
struct Point {
    double x = 0.0;  ///< to the right, foam units
    double y = 0.0;  ///< upward, foam units

    /// Returns true if all coordinates are equal.
    friend bool operator==(const Point&, const Point&) = default;
};

/// A bubble.
struct Bubble {
    std::int64_t identity = 0;  ///< unique; reused only if a boil (E9) revives the bubble
    std::int64_t sides = 0;     ///< number of films; 0 for a bubble that touches no other bubble
    double x = 0.0;             ///< centroid; on a torus, perhaps outside of the fundamental cell
    double y = 0.0;             ///< likewise
    double area = 0.0;          ///< within its curved films
    double target_area = 0.0;   ///< its area in equilibrium: represents the amount of gas
    /// In a patch, relative to the pressure outside. On a torus, determined only up to a common
    /// constant.
    double pressure = 0.0;
    double perimeter = 0.0;  ///< total length of its films
    /// The longer axis divided by the shorter axis of the ellipse with the same second moments of
    /// area as the bubble. NaN for an inverted bubble, whose area is not positive, and for some
    /// bubbles that overlap themselves.
    double elongation = 1.0;
    /// Angle from the x axis to the longer axis, counter-clockwise, in radians, -pi/2 to pi/2. NaN
    /// if the elongation is NaN.
    double orientation = 0.0;
};

/// A film: a circular arc between two bubbles, from its tail to its head.
struct Film {
    /// Index of the bubble on the left, or -1 for the outside or a hole of a patch.
    std::int64_t left = -1;
    /// Index of the bubble on the right, or -1 for the outside or a hole of a patch.
    std::int64_t right = -1;
    std::int64_t tail = 0;  ///< index of the junction at which the film begins
    /// Index of the junction at which the film ends. On a torus, the film may end at a periodic
    /// copy of this junction.
    std::int64_t head = 0;
    double x = 0.0;        ///< position of the tail
    double y = 0.0;        ///< position of the tail
    double chord_x = 0.0;  ///< vector from the tail to the end of the film
    double chord_y = 0.0;  ///< vector from the tail to the end of the film
    /// Half of the angle by which the arc turns, in radians. Positive if the arc bulges to the
    /// right, that is, if the pressure is higher on the left (E1).
    double half_angle = 0.0;
    double length = 0.0;  ///< of the arc
};

/// A foam at one instant. Indices refer to elements of these vectors.
struct FoamRecords {
    /// First the bubbles of the network, then those that touch no other bubble.
    std::vector<Bubble> bubbles;
    std::vector<Film> films;       ///< each film once
    std::vector<Point> junctions;  ///< the points at which three films meet
};

/// The domain of a foam. A torus is the plane modulo its two periods, the vectors (width, 0) and
/// (shear, height). Its fundamental cell is the rectangle [0, width) x [0, height) for any shear.
/// Whenever a torus is sheared, the magnitude of `shear` is reduced to at most half of the width.
/// For a patch in the plane, all numbers are 0.
struct Extent {
    double width = 0.0;   ///< x of the first period
    double height = 0.0;  ///< y of the second period
    double shear = 0.0;   ///< x of the second period

    /// Returns false for a patch.
    bool is_torus() const { return width > 0.0; }

    /// Returns true if all numbers are equal.
    friend bool operator==(const Extent&, const Extent&) = default;
};

/// The kinds of changes of topology.
enum class EventKind {
    T1,     ///< bubbles swapped neighbors; in a patch also: a film tore or a hole closed
    T2,     ///< a bubble vanished
    Birth,  ///< a bubble was added
};

/// A change of topology.
struct Event {
    EventKind kind = EventKind::T1;  ///< what happened
    /// Foam time at the start of the substep (a part of a time step) in which the change happened.
    double time = 0.0;
    Point position;  ///< where; on a torus, perhaps outside of the fundamental cell
    /// The identities of the bubbles whose neighbors changed. For T2 and Birth, the first is the
    /// bubble that vanished or was added.
    std::vector<std::int64_t> bubbles;
};

/// The stress tensor of a foam (E11): a force per length. Its unit is the unit of the film tension
/// divided by a foam unit. It is symmetric, and tension is positive. On a torus, xx and yy contain
/// the common constant of the pressures; xy and xx - yy do not depend on it.
struct Stress {
    double xx = 0.0;  ///< normal stress along x
    double xy = 0.0;  ///< shear stress
    double yy = 0.0;  ///< normal stress along y
};

}  // namespace foamtex
