// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/mean_bubble.h"

#include "core/foam/statistics.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

double area_of(MeanBubble bubble, const Frame& frame) {
    const double mean = bubble == MeanBubble::Current ? mean_area(frame) : 1.0;
    return mean > 0.0 ? mean : 1.0;  // the mean is 0 if no bubble is left
}

double diameter_of(MeanBubble bubble, const Frame& frame) {
    return 2.0 * std::numbers::inv_sqrtpi * std::sqrt(area_of(bubble, frame));
}

}  // namespace foam::texgen
