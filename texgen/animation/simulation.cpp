// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulation.h"

#include "core/dynamics/restore_rafts.h"
#include "core/foam/measure.h"
#include "texgen/animation/display_transform.h"
#include "texgen/animation/seed.h"
#include "texgen/animation/shown_states.h"
#include "texgen/animation/simulation_options.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// The foam is quasi-static, as in the paper (Section 4.1): each step ends in equilibrium. Before
// frame 1 the foam is seeded, equilibrated and warmed up. Warming up is a simulation over the time
// FramesOptions::warm_up. With FirstFrame::Diagram, the foam is equilibrated and warmed up before
// frame 2 instead. Every further frame is one step (core/dynamics/step.h). In a step, gas diffuses
// (E6) while the changes of the events (timeline.h) are imposed (E9). Loops differ from this
// sequence as follows:
// - breathe, shear, boil: a periodic change without diffusion (core/dynamics/cycle.h). Cycles run
//   before frame 1 until one cycle closes (close_loop), or, in a boil, two cycles in a row. This is
//   a search for a fixed point (loop_start.cpp). The frames are the steps of the next cycle. If a
//   state from which the loop closes is stored (loop_start.h), the simulation begins with this
//   state, and only one cycle runs before frame 1.
// - drift: no steps; each frame shows the same foam at another position (display_transform.h).
// - flow: steps as without a loop, while the timeline creates new bubbles; a cross-fade of two
//   states closes the loop (shown_states.h).
// - pingpong: steps as without a loop; the frames show the states forwards and then backwards.

namespace foam::texgen {

namespace {

void clamp_to_min(double min_time, std::vector<double>& times) {
    for (double& time : times) {
        time = std::max(time, min_time);
    }
}

}  // namespace

Simulation::Simulation(const Preset& preset, int threads, ProgressCallback on_progress)
    : Simulation(preset, seeded_foam(preset), threads, std::move(on_progress)) {}

Simulation::Simulation(const Preset& preset,
                       LoopStart start,
                       int threads,
                       ProgressCallback on_progress)
    : Simulation(preset, std::move(start.foam), threads, std::move(on_progress)) {
    cycle_.emplace(foam_, cycle_options_, std::move(start.drive));
    history_.set_pressures(std::move(start.first_pressures));
}

Simulation::Simulation(const Preset& preset, Foam foam, int threads, ProgressCallback on_progress)
    : frames_(preset.frames),
      loop_(preset.loop),
      image_(preset.image),
      camera_(preset.camera),
      next_step_(preset.frames.time_step),
      options_(step_options_of(preset, threads)),
      cycle_options_(cycle_options_of(preset)),
      has_several_parts_(preset.shape.kind == FoamKind::Patch &&
                         outline_of(preset.shape).size() > 1),
      foam_(std::move(foam)),
      timeline_(preset),
      history_(foam_, preset.frames.smoothing),
      on_progress_(std::move(on_progress)) {}

bool Simulation::advance() {
    ++number_;
    events_.clear();
    const bool reached = reach_frame();
    record_events(number_);
    if (number_ > 1) {
        history_.average_values(foam_);
    }
    return reached;
}

bool Simulation::reach_frame() {
    if (number_ == 1) {
        return reach_first_frame();
    }
    equilibrium_.relaxations = equilibrium_.sweeps = equilibrium_.iterations = 0;
    equilibrium_.t1 = equilibrium_.t2 = 0;
    if (number_ == 2 && frames_.first == FirstFrame::Diagram && !equilibrate_and_warm_up()) {
        return false;
    }
    if (cycle_) {
        return step_cycle(number_ - 1);
    }
    if (loop_.kind == LoopKind::Drift) {
        return true;
    }
    const double time = next_step_;
    next_step_ *= frames_.step_growth;
    return step_by(time, timeline_.changes_to(number_, foam_));
}

bool Simulation::reach_first_frame() {
    if (frames_.first == FirstFrame::Diagram) {
        measure_diagram();
    } else if (!cycle_ && !equilibrate_and_warm_up()) {
        return false;
    }
    record_events(number_);
    history_.forget_events();
    history_.average_values(foam_);
    if (foam_.domain.is_plane()) {
        view_ = camera_view(frame(), image_, camera_);
        timeline_.set_view(*view_);
    }
    return !loop_.is_cycle() || close_loop();
}

// Moves the topology events of the foam, which happened during the step to the given frame, into
// the history. Also appends them to events_, the events of this advance().
void Simulation::record_events(int frame) {
    events_.insert(events_.end(), foam_.events.begin(), foam_.events.end());
    history_.record_events(foam_, frame, strain_);
}

Frame Simulation::frame() const {
    if (!has_display_transform(loop_)) {
        return snapshot(foam_, number_);
    }
    return snapshot(transformed_for_display(foam_, loop_, loop_progress()), number_);
}

int Simulation::bubble_count() const {
    return static_cast<int>(foam_.network.bubble_count() + foam_.lone_bubbles.size());
}

LoopStart Simulation::loop_start() const {
    return {foam_, cycle_->drive(), history_.record().first_pressures};
}

FoamRecord Simulation::record() const {
    FoamRecord record = history_.record();
    for (RecordedEvent& event : record.events) {
        event.position =
            transformed_for_display(event.position, foam_.domain, loop_, loop_progress());
    }
    if (loop_.is_cycle()) {
        // Births of bubbles, and changes of their neighbors, count as at most one period old. The
        // record is therefore the same in every cycle.
        const double oldest = foam_.time - frames_.count * frames_.time_step;
        clamp_to_min(oldest, record.births);
        clamp_to_min(oldest, record.changes);
    }
    return record;
}

double Simulation::loop_progress() const {
    return foam::texgen::loop_progress(number_, loop_, frames_.count);
}

// Runs cycles, at most loop_.cycles, until a cycle closes: its closing error is below kClosed, and
// Cycle::repeats returns true. In a boil, two cycles in a row must close. The reason is that the
// closing error does not compare the flags of films that have flipped (Foam::t1_armed). The T1s of
// the next cycle may therefore still differ after one cycle has closed. From a LoopStart, one cycle
// that closes is enough: the last cycle before the stored state has closed, too, and the flags are
// stored with the foam. After each cycle of a boil that does not close, Cycle::calm reduces the
// oscillation of bubbles that keep changing neighbors. It also reduces the growth of the boiling
// bubbles nearest to them.
//
// Returns false if the loop does not close or if a step finds no equilibrium. The cycles before the
// last one are transients: some of their T1s and T2s do not recur. The last step of each cycle is
// recorded as the step to frame 1, and the other steps as steps to the frames before frame 1. The
// events of the last cycle therefore have frame numbers of at most 1.
bool Simulation::close_loop() {
    const bool is_stored = cycle_.has_value();
    if (!is_stored) {
        cycle_.emplace(foam_, cycle_options_);
    }
    const bool is_searched = loop_.kind == LoopKind::Boil && !is_stored;
    const int needed = is_searched ? 2 : 1;
    bool converged = is_stored || step_cycle(0);
    int closed = 0;
    for (int cycle = 0; cycle < loop_.cycles && converged; ++cycle) {
        const Foam start = foam_;
        const FoamRecord record = history_.record();
        history_.renumber(-frames_.count);
        RunProgress progress{
            .phase = Phase::LoopClosing,
            .total = frames_.count,
            .measure = closing_error_,
            .cycle = cycle + 1,
            .usual_cycles = is_searched ? std::min(usual_cycles(bubble_count()), loop_.cycles) : 0};
        for (int position = 1; position <= frames_.count && converged; ++position) {
            progress.done = position - 1;
            report(progress);
            converged = step_cycle(position);
            record_events(1 + position - frames_.count);
            history_.average_values(foam_);
        }
        closing_error_ = foam::closing_error(start, foam_);
        if (!converged) {
            return false;
        }
        progress.done = frames_.count;
        progress.measure = closing_error_;
        report(progress);
        const bool closes = *closing_error_ < kClosed && cycle_->repeats();
        closed = closes ? closed + 1 : 0;
        if (closed == needed) {
            history_.close_averages(record, frames_.count);
            return true;
        }
        if (!closes) {
            cycle_->calm(foam_);
        }
    }
    return false;
}

bool Simulation::step_cycle(int position) {
    return add_step(cycle_->step_to(position, foam_, frames_.time_step, options_));
}

bool Simulation::add_step(const StepSummary& step) {
    const EquilibriumSummary before = equilibrium_;
    equilibrium_ = step.equilibrium;
    equilibrium_.add_work(before);
    equilibrium_.t1 += before.t1;
    equilibrium_.t2 += before.t2;
    relaxations_ += step.equilibrium.relaxations;
    strain_ += step.strain;
    return equilibrium_.converged();
}

void Simulation::measure_diagram() {
    const EquilibriumErrors errors = equilibrium_errors(foam_);
    equilibrium_.area_error = errors.area;
    equilibrium_.angle_error = errors.angle;
    equilibrium_.energy = energy(foam_);
}

bool Simulation::equilibrate_and_warm_up() {
    report({.phase = Phase::Equilibrium});
    // The camera shows a single raft wherever it is; several rafts, such as the letters of a word,
    // must keep their places.
    const auto equilibrate = has_several_parts_ ? equilibrate_keeping_rafts : equilibrate_with;
    equilibrium_ = equilibrate(options_.solver, foam_, options_.equilibrium);
    if (!equilibrium_.converged() || !warm_up()) {
        return false;
    }
    history_.record_pressures(foam_);
    return true;
}

// The warm-up of a flow consists of equal steps, each at most as long as the time step of a frame.
// Before each step, new bubbles replace the bubbles that have vanished. The last step leads to
// state 1, since numbered states begin after the warm-up (shown_states.h). Without a flow, the
// warm-up is one step.
bool Simulation::warm_up() {
    if (loop_.kind != LoopKind::Flow) {
        if (frames_.warm_up > 0.0) {
            report({.phase = Phase::WarmUp, .total = 1});
        }
        return step_by(frames_.warm_up, {});
    }
    const int steps = static_cast<int>(std::ceil(frames_.warm_up / frames_.time_step));
    for (int frame = 2 - steps; frame <= 1; ++frame) {
        report({.phase = Phase::WarmUp, .done = frame - 2 + steps, .total = steps});
        if (!step_by(frames_.warm_up / steps, timeline_.changes_to(frame, foam_))) {
            return false;
        }
    }
    return true;
}

bool Simulation::step_by(double time, const StateChange& change) {
    if (time == 0.0 && change.empty()) {
        return true;
    }
    return add_step(step(foam_, time, change, options_));
}

void Simulation::report(RunProgress progress) const {
    if (on_progress_) {
        progress.bubbles = bubble_count();
        on_progress_(progress);
    }
}

}  // namespace foam::texgen
