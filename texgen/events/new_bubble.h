// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_context.h"

#include <optional>

namespace foam::texgen {

/// The element of the foam on which a new bubble appears.
enum class NucleationSite { Junction, Film };

/// Creates a bubble with the target area `area`, in square foam units, on the junction or film
/// nearest to a point. Returns nullopt, and leaves the foam unchanged, if the point is in no bubble
/// of the network, or if the bubbles around the junction or film have too little gas
/// (core/dynamics/nucleation.h). Precondition: the target area is positive.
std::optional<BubbleId> nucleate_near(NucleationSite site,
                                      const Vec2& point,
                                      double area,
                                      Foam& foam);

/// Creates a bubble near a random point of a torus, or of the bounding box of a patch's junctions.
/// Tries up to 100 points and uses the first point at which nucleate_near succeeds. Returns nullopt
/// if nucleate_near succeeds at none of them.
std::optional<BubbleId> nucleate_anywhere(NucleationSite site,
                                          double area,
                                          Random& random,
                                          Foam& foam);

/// Returns the initial target area of a new bubble that will grow to `area`. It is twice the T2
/// area, so that the bubble does not vanish at once, but at most `area`.
double first_area(double area, double t2_area);

/// Adds a schedule to `schedules` that drives a new bubble from its present target area to `area`
/// over the given frames.
void grow_bubble(const Foam& foam,
                 BubbleId bubble,
                 const FrameSpan& frames,
                 double area,
                 DrivenSchedules& schedules);

}  // namespace foam::texgen
