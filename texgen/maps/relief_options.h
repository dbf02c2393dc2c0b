#pragma once

#include "texgen/maps/mean_bubble.h"
#include "texgen/maps/relief_section.h"

namespace foam::texgen {

/// The relief that height, normal, occlusion and curvature show.
struct ReliefOptions {
    ReliefProfile profile = ReliefProfile::Dome;
    double angle = 50.0;    // of domes at films, degrees
    double width = 0.2;     // of a ridge from its film to its foot, or the radius of borders; in
                            // diameters of the mean bubble
    double strength = 1.0;  // factor on heights
    MeanBubble mean_bubble = MeanBubble::Current;  // whose diameter heights and widths are in
};

}  // namespace foam::texgen
