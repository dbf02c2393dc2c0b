// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/frame_assembly.h"

#include "texgen/animation/display_transform.h"
#include "texgen/animation/shared_bubbles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

// Each frame is a request for one to four states. Requests are sorted by the last state that they
// need, so that a frame can be emitted as soon as that state is added. A state is released when no
// further request needs it.

namespace foam::texgen {

namespace {

// Returns the frame with its number set to `number`. Copies the frame only if its number differs.
std::shared_ptr<const Frame> renumbered(const std::shared_ptr<const Frame>& frame, int number) {
    if (frame->number == number) {
        return frame;
    }
    Frame copy = *frame;
    copy.number = number;
    return std::make_shared<const Frame>(std::move(copy));
}

double aspect_of(const ImageOptions& image) {
    return static_cast<double>(image.width) / image.height;
}

FadeOrder fade_order_of(const Preset& preset) {
    return FadeOrder({.bubbles = static_cast<double>(preset.seeding.bubbles),
                      .spread = preset.loop.fade_spread,
                      .aspect = aspect_of(preset.image),
                      .seed = preset.seeding.seed});
}

// Moves a state, and the events of its record, by the current of the loop (current.h).
void carry(const Current& current, double progress, DrawnState& state) {
    FoamRecord record = *state.record;
    for (RecordedEvent& event : record.events) {
        event.position += current.displacement(event.position, state.frame->domain, progress);
    }
    state.record = std::make_shared<const FoamRecord>(std::move(record));
    state.frame = std::make_shared<const Frame>(current.carried(*state.frame, progress));
}

// Moves two frames toward each other, so that bubbles that are in both are at about the same
// positions. The frame that fades out moves by the fraction `passed` of the distance, the frame
// that fades in by the remaining fraction.
void move_together(double passed,
                   std::shared_ptr<const Frame>& fading_out,
                   std::shared_ptr<const Frame>& fading_in) {
    auto moved_out = std::make_shared<const Frame>(moved_toward(*fading_out, *fading_in, passed));
    fading_in = std::make_shared<const Frame>(moved_toward(*fading_in, *fading_out, 1.0 - passed));
    fading_out = std::move(moved_out);
}

}  // namespace

FrameAssembly::FrameAssembly(const Preset& preset,
                             const std::vector<int>& numbers,
                             NextFrames next_frames,
                             FrameVisitor on_frame)
    : includes_next_(next_frames == NextFrames::Included),
      loop_(preset.loop),
      count_(preset.frames.count),
      first_state_(shown_states(1, loop_, count_).state),
      on_frame_(std::move(on_frame)) {
    if (loop_.current > 0.0) {
        current_ =
            std::make_shared<const Current>(loop_, aspect_of(preset.image), preset.seeding.seed);
    }
    if (loop_.is_cross_faded()) {
        fade_order_.emplace(fade_order_of(preset));
    }
    uses_[first_state_];  // makes states() include the state of frame 1
    for (const int number : numbers) {
        requests_.push_back(request_of(number, preset));
        for (const int state : requests_.back().states) {
            ++uses_[state];
        }
    }
    std::ranges::sort(requests_, [](const Request& a, const Request& b) {
        return std::pair(a.states.back(), a.number) < std::pair(b.states.back(), b.number);
    });
}

FrameAssembly::Request FrameAssembly::request_of(int number, const Preset& preset) const {
    const ShownStates shown = shown_states(number, preset.loop, preset.frames.count);
    Request request{number, shown, {shown.state}};
    if (includes_next_) {
        request.states.push_back(shown.next);
    }
    if (shown.is_cross_fade()) {
        request.states.push_back(shown.fading_in);
    }
    if (includes_next_ && shown.next_fading_in > 0) {
        request.states.push_back(shown.next_fading_in);
    }
    std::ranges::sort(request.states);
    return request;
}

std::vector<int> FrameAssembly::states() const {
    std::vector<int> all;
    for (const auto& [state, uses] : uses_) {
        all.push_back(state);
    }
    return all;
}

void FrameAssembly::add_effort(const FrameEffort& effort) {
    total_.t1 += effort.t1;
    total_.t2 += effort.t2;
    total_.seconds += effort.seconds;
    unreported_.insert(unreported_.end(), effort.events.begin(), effort.events.end());
    event_count_ += effort.events.size();
}

void FrameAssembly::add(const SimulatedFrame& state) {
    add_effort(state.effort);
    const int number = state.frame->number;
    if (uses_.at(number) > 0) {
        keep(state);
    }
    if (number == first_state_) {
        first_ = frame_one_of(state);
    }
    while (emitted_ < requests_.size() && requests_[emitted_].states.back() <= number) {
        emit(requests_[emitted_]);
        release(requests_[emitted_]);
        ++emitted_;
    }
}

void FrameAssembly::keep(const SimulatedFrame& state) {
    SimulatedFrame frame = prepared(state);
    frame.effort.events.clear();
    frame.effort.t1 = total_.t1;
    frame.effort.t2 = total_.t2;
    frame.effort.seconds = total_.seconds;
    const int number = state.frame->number;
    kept_.emplace(number, std::move(frame));
    event_counts_.emplace(number, event_count_);
}

// Returns frame 1. If no requested frame uses the state of frame 1, this state has not been moved
// by the current. The current is then applied only when a map needs frame 1, because few maps do.
std::shared_ptr<const FrameOne> FrameAssembly::frame_one_of(const SimulatedFrame& state) const {
    const auto kept = kept_.find(first_state_);
    if (kept != kept_.end()) {
        return std::make_shared<const FrameOne>(kept->second.frame);
    }
    if (!current_) {
        return std::make_shared<const FrameOne>(state.frame);
    }
    const double progress = loop_progress(first_state_, loop_, count_);
    return std::make_shared<const FrameOne>([current = current_, frame = state.frame, progress] {
        return std::make_shared<const Frame>(current->carried(*frame, progress));
    });
}

// Returns a state of the simulation in the form in which it is kept. If the loop has a cross-fade,
// the ranks of the bubbles (FadeOrder) are added. If there is a current, the foam is moved by it.
// Ranks are computed for the positions before the drift and the current, so that a bubble keeps its
// rank.
SimulatedFrame FrameAssembly::prepared(const SimulatedFrame& state) const {
    SimulatedFrame frame = state;
    const double progress = loop_progress(state.frame->number, loop_, count_);
    if (fade_order_) {
        frame.fade_ranks = fade_order_->ranks(
            *state.frame, drift_displacement(state.frame->domain, loop_, progress));
    }
    if (current_) {
        carry(*current_, progress, frame);
    }
    return frame;
}

void FrameAssembly::emit(const Request& request) {
    const ShownStates& shown = request.shown;
    SimulatedFrame frame = kept_.at(shown.state);
    frame.effort = effort_since_last(frame.effort, event_counts_.at(shown.state));
    static_cast<DrawnState&>(frame) = drawn(shown.state, shown.next);
    frame.frame = renumbered(frame.frame, request.number);
    if (shown.is_cross_fade()) {
        add_cross_fade(request, frame);
    }
    if (includes_next_ && shown.next_fading_in > 0) {
        move_next(shown, frame);
    }
    on_frame_(frame);
}

// Adds the foam that fades in. Bubbles that are in both foams (displacements_of_shared) are moved
// to about the same positions. Such a bubble does not grow. When its growth would be half complete,
// its copy in the foam that fades in replaces its copy in the other foam in one step. All other
// bubbles of the foam that fades in grow.
void FrameAssembly::add_cross_fade(const Request& request, SimulatedFrame& frame) const {
    const ShownStates& shown = request.shown;
    const double passed = shown.fade_progress;
    frame.fading_in = drawn(shown.fading_in, shown.next_fading_in);
    frame.fading_in.frame = renumbered(frame.fading_in.frame, request.number);
    const std::vector<std::optional<Vec2>> shared =
        displacements_of_shared(*frame.fading_in.frame, *frame.frame);
    for (std::size_t k = 0; k < shared.size(); ++k) {
        const double growth = fade_order_->growth(frame.fading_in.fade_ranks[k], passed);
        frame.fade_growth.push_back(shared[k] ? std::floor(growth + 0.5) : growth);
    }
    move_together(passed, frame.frame, frame.fading_in.frame);
}

// Moves `frame.next` and, in a cross-fade, `frame.fading_in.next` to the positions at which the
// next frame of the animation shows them. In the last frame before the fade, only `frame.next` is
// moved: this frame is not a cross-fade, but the next one is.
void FrameAssembly::move_next(const ShownStates& shown, SimulatedFrame& frame) const {
    const double passed =
        static_cast<double>(shown.next_fading_in) / (states_before_first_frame(loop_, count_) + 1);
    std::shared_ptr<const Frame> fading_in = kept_.at(shown.next_fading_in).frame;
    move_together(passed, frame.next, fading_in);
    if (shown.is_cross_fade()) {
        frame.fading_in.next = std::move(fading_in);
    }
}

DrawnState FrameAssembly::drawn(int state, int next) const {
    DrawnState drawn = kept_.at(state);
    drawn.first = first_;
    if (includes_next_) {
        drawn.next = kept_.at(next).frame;
    }
    return drawn;
}

void FrameAssembly::release(const Request& request) {
    for (const int state : request.states) {
        if (--uses_.at(state) == 0) {
            kept_.erase(state);
            event_counts_.erase(state);
        }
    }
}

// Returns the part of the effort `total` that emitted frames have not reported yet. `total` is the
// effort from the start of the simulation to a state, and `event_count` is the number of events up
// to this state. Emitted frames may already have reported the effort up to this state or a later
// one. The result then has no events, and its counts and its time are 0. The measurements in the
// result are the measurements of the state.
FrameEffort FrameAssembly::effort_since_last(const FrameEffort& total, std::size_t event_count) {
    FrameEffort effort = total;
    if (total.seconds < reported_.seconds) {
        effort.t1 = effort.t2 = 0;
        effort.seconds = 0.0;
        return effort;
    }
    effort.t1 -= reported_.t1;
    effort.t2 -= reported_.t2;
    effort.seconds -= reported_.seconds;
    const std::size_t reported_events = event_count_ - unreported_.size();
    const auto end =
        unreported_.begin() +
        static_cast<std::ptrdiff_t>(std::max(event_count, reported_events) - reported_events);
    effort.events.assign(unreported_.begin(), end);
    unreported_.erase(unreported_.begin(), end);
    reported_ = total;
    return effort;
}

std::vector<int> states_of(const Preset& preset,
                           const std::vector<int>& frames,
                           NextFrames next_frames) {
    return FrameAssembly(preset, frames, next_frames, {}).states();
}

}  // namespace foam::texgen
