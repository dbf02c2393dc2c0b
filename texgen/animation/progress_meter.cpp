// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_meter.h"

namespace foam::texgen {

ProgressMeter::ProgressMeter(int total, const ProgressCallback& on_progress)
    : on_progress_(on_progress) {
    progress_.total = total;
}

void ProgressMeter::add(const SimulatedFrame& shown) {
    const Frame& frame = *shown.frame;
    ++progress_.done;
    progress_.frame = frame.number;
    progress_.bubbles = static_cast<int>(frame.bubbles.size() + frame.lone_bubbles.size());
    progress_.area_error = shown.effort.area_error;
    progress_.angle_error = shown.effort.angle_error;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    progress_.seconds = passed.count();
    if (on_progress_) {
        on_progress_(progress_);
    }
}

}  // namespace foam::texgen
