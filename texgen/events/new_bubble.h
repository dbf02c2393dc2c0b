#pragma once

#include "texgen/events/event_stage.h"

#include <optional>

namespace foam::texgen {

/// The site of a new bubble.
enum class NucleationSite { Junction, Film };

/// Makes a bubble of a target area, above 0, on the junction or film nearest to a point. Returns
/// nothing, and changes nothing, outside of a patch and where there is too little gas
/// (nucleation.h).
std::optional<BubbleId> nucleate_near(NucleationSite on,
                                      const Vec2& point,
                                      double area,
                                      Foam& foam);

/// Makes a bubble near a random point of a torus, or of the bounding box of a patch: at the first
/// of up to 100 points at which it is possible.
std::optional<BubbleId> nucleate_anywhere(NucleationSite on,
                                          double area,
                                          Random& random,
                                          Foam& foam);

/// Returns the area of a new bubble that is to grow to `area`: small, but large enough that it does
/// not vanish at once.
double first_area(double area, double t2_area);

/// Drives a new bubble to its area over some frames.
void grow_bubble(const Foam& foam,
                 BubbleId bubble,
                 const FrameSpan& frames,
                 double area,
                 DrivenCourses& courses);

}  // namespace foam::texgen
