// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam {

/// The shape of a bubble. Elongation and orientation are properties of an ellipse (M. R. Teague, J.
/// Opt. Soc. Am. 70, 920, 1980). The ellipse has the same second moments of area about its center
/// as the region within the arcs of the bubble.
struct BubbleShape {
    Vec2 center{0.0, 0.0};    // centroid; on a torus it may be outside of the fundamental cell
    double perimeter = 0.0;   // length of all films around the bubble
    double elongation = 1.0;  // longer axis of the ellipse divided by the shorter axis; at least 1
    // The angle from the x axis to the longer axis of the ellipse, counter-clockwise, in radians,
    // from -pi/2 to pi/2. It means little if the elongation is nearly 1; a circle has the angle 0.
    double orientation = 0.0;
};

/// Returns the shape of a bubble of the network. If the bubble is inverted, so that its area is not
/// positive, elongation and orientation are NaN, and the center is its first junction. Elongation
/// and orientation are also NaN if the bubble overlaps itself so that no ellipse has its second
/// moments.
BubbleShape bubble_shape(const Frame& frame, BubbleId bubble);

/// Returns the shape of a lone bubble, a circle.
BubbleShape bubble_shape(const LoneBubble& bubble);

}  // namespace foam
