// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_meter.h"

namespace foam::texgen {

ProgressMeter::ProgressMeter(Phase phase, int total, const ProgressCallback& on_progress)
    : on_progress_(on_progress) {
    progress_.phase = phase;
    progress_.total = total;
}

void ProgressMeter::begin() {
    const std::scoped_lock lock(mutex_);
    if (!begun_) {
        report();
    }
}

void ProgressMeter::add() {
    const std::scoped_lock lock(mutex_);
    ++progress_.done;
    report();
}

void ProgressMeter::add(const SimulatedFrame& shown) {
    const std::scoped_lock lock(mutex_);
    const Frame& frame = *shown.frame;
    ++progress_.done;
    progress_.frame = frame.number;
    progress_.bubbles = static_cast<int>(frame.bubbles.size() + frame.lone_bubbles.size());
    progress_.area_error = shown.effort.area_error;
    progress_.angle_error = shown.effort.angle_error;
    report();
}

ProgressCallback ProgressMeter::for_source() {
    return [this](const RunProgress& progress) {
        const std::scoped_lock lock(mutex_);
        if (begun_) {
            report();
        } else if (on_progress_) {
            on_progress_(progress);
        }
    };
}

void ProgressMeter::report() {
    begun_ = true;
    if (on_progress_) {
        on_progress_(progress_);
    }
}

}  // namespace foam::texgen
