// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_stage.h"

#include <optional>

namespace foam::texgen {

/// The site of a new bubble.
enum class NucleationSite { Junction, Film };

/// Makes a bubble on the junction or film nearest to a point. Returns nullopt, and leaves the foam
/// unchanged, if the point is in no bubble of the network or if there is too little gas around it
/// (nucleation.h). Precondition: the target area is above 0.
std::optional<BubbleId> nucleate_near(NucleationSite on,
                                      const Vec2& point,
                                      double area,
                                      Foam& foam);

/// Makes a bubble near a random point of a torus, or of the bounding box of a patch's junctions.
/// Tries up to 100 points and uses the first one at which nucleate_near succeeds. Returns nullopt
/// if none does.
std::optional<BubbleId> nucleate_anywhere(NucleationSite on,
                                          double area,
                                          Random& random,
                                          Foam& foam);

/// Returns the initial area of a new bubble that will grow to `area`: twice the T2 area, so that it
/// does not vanish at once, and at most `area`.
double first_area(double area, double t2_area);

/// Drives a new bubble from its present target area to `area` over the given frames.
void grow_bubble(const Foam& foam,
                 BubbleId bubble,
                 const FrameSpan& frames,
                 double area,
                 DrivenCourses& courses);

}  // namespace foam::texgen
