// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/frame_assembly.h"

#include <algorithm>
#include <utility>

// Each frame is a request for one to four states. Requests are sorted by the last state that they
// need, so a frame is handed out as soon as that state is added. The number of open requests per
// state decides when a state is released.

namespace foam::texgen {

namespace {

// Returns the frame with the given number; copies it only if its number differs.
std::shared_ptr<const Frame> renumbered(const std::shared_ptr<const Frame>& frame, int number) {
    if (frame->number == number) {
        return frame;
    }
    Frame copy = *frame;
    copy.number = number;
    return std::make_shared<const Frame>(std::move(copy));
}

}  // namespace

FrameAssembly::FrameAssembly(const Preset& preset,
                             const std::vector<int>& numbers,
                             NextFrames next_frames,
                             FrameVisitor on_frame)
    : hands_out_next_(next_frames == NextFrames::HandedOut), on_frame_(std::move(on_frame)) {
    if (preset.shape.kind == FoamKind::Patch) {
        uses_[1];
    }
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
    if (hands_out_next_) {
        request.states.push_back(shown.next);
    }
    if (shown.is_cross_fade()) {
        request.states.push_back(shown.rising);
        if (hands_out_next_) {
            request.states.push_back(shown.rising_next());
        }
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

void FrameAssembly::add(const SimulatedFrame& state) {
    total_.t1 += state.effort.t1;
    total_.t2 += state.effort.t2;
    total_.seconds += state.effort.seconds;
    total_.area_error = state.effort.area_error;
    total_.angle_error = state.effort.angle_error;
    const int number = state.frame->number;
    if (uses_.at(number) > 0) {
        kept_.emplace(number, state).first->second.effort = total_;
    }
    while (handed_out_ < requests_.size() && requests_[handed_out_].states.back() <= number) {
        hand_out(requests_[handed_out_]);
        release(requests_[handed_out_]);
        ++handed_out_;
    }
}

void FrameAssembly::hand_out(const Request& request) {
    const ShownStates& shown = request.shown;
    SimulatedFrame frame = kept_.at(shown.state);
    frame.effort = effort_since_last(frame.effort);
    static_cast<DrawnState&>(frame) = drawn(shown.state, shown.next);
    frame.frame = renumbered(frame.frame, request.number);
    if (shown.is_cross_fade()) {
        frame.rising = drawn(shown.rising, shown.rising_next());
        frame.rising.frame = renumbered(frame.rising.frame, request.number);
        frame.faded = shown.faded;
    }
    on_frame_(frame);
}

DrawnState FrameAssembly::drawn(int state, int next) const {
    DrawnState drawn = kept_.at(state);
    if (hands_out_next_) {
        drawn.next = kept_.at(next).frame;
    }
    return drawn;
}

void FrameAssembly::release(const Request& request) {
    for (const int state : request.states) {
        if (--uses_.at(state) == 0) {
            kept_.erase(state);
        }
    }
}

// Returns the part of a total effort that no frame has reported. It is 0 if an earlier state is
// shown again. The errors of the state are unchanged.
FrameEffort FrameAssembly::effort_since_last(const FrameEffort& total) {
    FrameEffort effort = total;
    if (total.seconds < reported_.seconds) {
        effort.t1 = effort.t2 = 0;
        effort.seconds = 0.0;
        return effort;
    }
    effort.t1 -= reported_.t1;
    effort.t2 -= reported_.t2;
    effort.seconds -= reported_.seconds;
    reported_ = total;
    return effort;
}

}  // namespace foam::texgen
