// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/target_course.h"

#include <cmath>
#include <numbers>

namespace foam {

double target_at(const TargetCourse& course, double passed) {
    const double ramp = course.from + (course.to - course.from) * passed;
    const double turns = course.swings * passed + course.phase;
    return ramp * (1.0 + course.amplitude * std::sin(2.0 * std::numbers::pi * turns));
}

}  // namespace foam
