// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/phase_clock.h"

#include <algorithm>

namespace foam::texgen {

namespace {

// The number of reports from which the speed is computed (PhaseClock::seconds_per_unit):
// - the first report of the phase, or of the present cycle of a loop;
// - the next report in which more units are done than before;
// - the latest such report.
constexpr std::size_t kMarks = 3;

double seconds_between(PhaseClock::Clock::time_point from, PhaseClock::Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

bool is_preparation(Phase phase) {
    return phase < Phase::Ranges;
}

PhaseClock::News PhaseClock::add(const RunProgress& progress, Clock::time_point now) {
    const bool same_phase = latest_ && latest_->phase == progress.phase;
    const bool continues =
        same_phase && latest_->cycle == progress.cycle && latest_->done <= progress.done;
    if (!continues) {
        marks_.clear();
    }
    const bool has_units = marks_.empty() || marks_.back().done < progress.done;
    if (has_units) {
        if (marks_.size() == kMarks) {
            marks_.pop_back();
        }
        marks_.push_back({now, progress.done});
    }
    latest_ = progress;
    now_ = now;
    if (!same_phase) {
        return News::NewPhase;
    }
    return has_units ? News::Units : News::Nothing;
}

double PhaseClock::seconds_in_phase() const {
    return marks_.empty() ? 0.0 : seconds_between(marks_.front().time, now_);
}

std::optional<double> PhaseClock::seconds_per_unit() const {
    if (marks_.size() < kMarks) {
        return std::nullopt;
    }
    const Mark& last = marks_.back();
    double largest = 0.0;
    for (std::size_t k = 0; k + 1 < kMarks; ++k) {
        const double mean =
            seconds_between(marks_[k].time, last.time) / (last.done - marks_[k].done);
        largest = std::max(largest, mean);
    }
    return largest;
}

std::optional<double> PhaseClock::seconds_left() const {
    const std::optional<double> per_unit = seconds_per_unit();
    if (!per_unit || is_preparation(latest_->phase)) {
        return std::nullopt;
    }
    const double since_last = seconds_between(marks_.back().time, now_);
    const int units = latest_->total - latest_->done;
    return std::max(0.0, units * *per_unit - since_last);
}

}  // namespace foam::texgen
