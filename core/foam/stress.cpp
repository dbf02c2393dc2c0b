// SPDX-License-Identifier: Apache-2.0

#include "core/foam/stress.h"

#include "core/foam/measure.h"

#include <numbers>

namespace foam {

// Along an arc of half angle alpha, the direction of the tangent runs evenly from -alpha to alpha
// about the direction of the chord d. The mean of the squared cosine of this angle is
// 1/2 + sin(2 alpha) / (4 alpha), and the length of the arc is c alpha / sin alpha.
Mat2 tangent_integral(const FilmArc& arc) {
    const double c = arc.chord.norm();
    if (c == 0.0) {
        return Mat2::Zero();
    }
    const double cosine = ieee::cos(arc.half_angle);
    const Mat2 along = arc.chord * arc.chord.transpose();
    return 0.5 * (arc_length(arc) - c * cosine) * Mat2::Identity() + cosine / c * along;
}

Mat2 stress(const Frame& frame) {
    Mat2 tension = Mat2::Zero();
    double gas = 0.0;  // sum of pressure times area
    double area = 0.0;
    for (const FilmId film : frame.network.films()) {
        tension += tangent_integral(frame.arcs[film]);
    }
    for (const BubbleId bubble : frame.network.bubbles()) {
        gas += frame.bubbles[bubble].pressure * frame.bubbles[bubble].area;
        area += frame.bubbles[bubble].area;
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        const double radius = lone_radius(bubble);
        tension += std::numbers::pi * radius * Mat2::Identity();
        gas += frame.film_tension / radius * bubble.target_area;
        area += bubble.target_area;
    }
    if (area == 0.0) {
        return Mat2::Zero();
    }
    return (frame.film_tension * tension - gas * Mat2::Identity()) / area;
}

}  // namespace foam
