// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/target_area_schedule.h"

#include "core/geometry/elementary.h"

#include <numbers>

namespace foam {

double target_at(const TargetAreaSchedule& schedule, double passed) {
    const double ramp = schedule.from + (schedule.to - schedule.from) * passed;
    const double turns = schedule.oscillations * passed + schedule.phase;
    return ramp * (1.0 + schedule.amplitude * ieee::sin(2.0 * std::numbers::pi * turns));
}

}  // namespace foam
