// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/target_area_schedule.h"

#include <cmath>
#include <numbers>

namespace foam {

double target_at(const TargetAreaSchedule& schedule, double passed) {
    const double ramp = schedule.from + (schedule.to - schedule.from) * passed;
    const double turns = schedule.oscillations * passed + schedule.phase;
    return ramp * (1.0 + schedule.amplitude * std::sin(2.0 * std::numbers::pi * turns));
}

}  // namespace foam
