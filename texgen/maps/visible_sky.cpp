// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/visible_sky.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <span>

namespace foam::texgen {

namespace {

// The visible fraction of the sky is computed once per image for points of a ReliefSection. For
// each pixel, the fraction is looked up by the distance from the nearest film. The nearest film is
// treated as straight and endless, with the same section everywhere along it. The visible fraction
// of a uniform sky is then (sin a + sin b) / 2. Here a and b are the angles from the normal of the
// relief to the horizons on both sides. The horizon on one side is the steepest line from the point
// to a sample of the section on that side. If the tangent at the point is steeper, the tangent is
// the horizon.

double distance_at(int step) {
    return static_cast<double>(step) / SkyLookup::kSteps;
}

double height_at(const ReliefSection& section, double distance) {
    return section.visit([=](const auto& profile) { return height_along(profile, distance); });
}

// Returns the derivative of the section's height with respect to the distance x from the film.
// The smooth distance is s = x - x²/2 for domes, and s = x for other profiles.
double slope_at(const ReliefSection& section, double distance) {
    const double smooth = section.smooth(distance);
    const double slope_of_smooth = section.is_dome() ? 1.0 - distance : 1.0;  // ds/dx
    return section.slope(smooth) * slope_of_smooth;
}

// Returns the visible fraction of the sky at the sample `current`, where the section has the
// given slope.
double visible(std::span<const double> heights, int current, double slope) {
    // Returns the slope of the line to the horizon in the direction `step`, which is -1 or 1.
    // The slope is positive if the line rises.
    const auto steepest = [&](int step) {
        double steepness = step * slope;
        const double height = heights[static_cast<std::size_t>(current)];
        for (int k = current + step; k >= 0 && k < std::ssize(heights); k += step) {
            const double rise = heights[static_cast<std::size_t>(k)] - height;
            steepness = std::max(steepness, rise / distance_at(std::abs(k - current)));
        }
        return steepness;
    };
    constexpr double kRightAngle = 0.5 * std::numbers::pi;
    const double tilt = ieee::atan(slope);  // how far the normal tilts to the left
    const double left = kRightAngle - ieee::atan(steepest(-1)) - tilt;
    const double right = kRightAngle - ieee::atan(steepest(1)) + tilt;
    return 0.5 * (ieee::sin(left) + ieee::sin(right));
}

}  // namespace

VisibleSky::VisibleSky(const ReliefSection& section, double strength, double exponent) {
    const int reach = static_cast<int>(section.reach() * SkyLookup::kSteps);
    const int end = reach + SkyLookup::kSteps;
    std::vector<double> heights;  // at the samples from -end to end
    for (int k = -end; k <= end; ++k) {
        heights.push_back(strength * height_at(section, distance_at(k)));
    }
    for (int k = 0; k <= reach; ++k) {
        const double slope = strength * slope_at(section, distance_at(k));
        table_.push_back(ieee::pow_of_positive(visible(heights, k + end, slope), exponent));
    }
}

}  // namespace foam::texgen
